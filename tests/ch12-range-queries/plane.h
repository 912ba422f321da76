// Tests of the neighbors in the plane.
#pragma once

void k_nearest_in_the_plane(void);
void within_in_the_plane(void);
void lists_by_blocks(void);
void crowds_are_no_squares(void);

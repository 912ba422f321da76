// Tests of the neighbors in the plane.
#pragma once

void neighbors_in_the_plane(void);
void lists_by_blocks(void);
void crowds_are_no_squares(void);

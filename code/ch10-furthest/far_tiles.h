//> Declare the search far by tiles
// With wraparound the furthest point is near, as the sum of the axes'
// separations goes. So it is in the window, or the table, in which
// chapter 9 looks for the nearest. Eight points ask together, a second
// sweep finds out for each who is furthest and whether, with all
// rounding, nobody else can be. Those for whom that does not settle it
// look around, and then from outside.
#pragma once
#include "ch09-row-spans/carry.h"

// Only with wraparound; threads and space are the question's, the
// instruction set is isa_chosen(). The points may have any number in a
// cell, where they stand in ascending order. The nearest are found,
// too, and not sent back if their arrays are NULL.
void search_far_tiles(const struct question *question,
                      const struct carried *carried,
                      struct answers *answers);
//<

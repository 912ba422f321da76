//> Declare the search far by tiles
// With wraparound the furthest point is near, as the sum of the axes'
// separations goes. So the furthest neighbors of sorted points are
// found as chapter 9 finds the nearest: eight points ask together, what
// lies around them is copied to a table, and a sweep over it finds out
// for each who is furthest and whether, with all rounding, nobody else
// can be. Those for whom that does not settle it look from outside.
#pragma once
#include "ch04-cell-sort/sorted.h"

// Furthest only, and only with wraparound; threads and space are the
// question's, the instruction set is isa_chosen(). The points may have
// any number in a cell, where they stand in ascending order.
void search_far_tiles(const struct question *question,
                      const struct sorted *sorted,
                      struct answers *answers);
//<

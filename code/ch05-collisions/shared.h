//> Declare the sorts by shared counts
// Two ways to let threads count and place the points of chapter 4's
// sort: all of them in the same counts, atomically, or each in its own.
#pragma once
#include "ch04-cell-sort/cells.h"

// One count a cell for everybody. Inside a cell the points stand in
// the order in which the threads came: not cells_sort's, and not the
// same in every run.
struct cells cells_sort_atomic(const struct grid *grid,
                               struct points points, int threads);

// One count a cell and thread, so as many 32-bit numbers more. The
// same as cells_sort, for any number of threads.
struct cells cells_sort_private(const struct grid *grid,
                                struct points points, int threads);

// count[k * m + c] is how many of share k's points are in cell c; it
// becomes the place of the first of them, all cells in order, and in a
// cell all shares in order. start[0 .. m] is where the cells begin.
void scan_shares(uint32_t *count, uint32_t m, int shares,
                 uint32_t *start);
//<

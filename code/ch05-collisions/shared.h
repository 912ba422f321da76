//> Declare the sorts by shared counts
// Two ways to let threads count and place the points of chapter 4's
// sort: all of them in the same counts, atomically, or each in its own
// (Zagha and Blelloch 1991, for the lanes of a Cray).
#pragma once
#include "ch04-cell-sort/cells.h"

// One count a cell for everybody. Inside a cell the points stand in
// the order in which the threads came: not cells_sort's, and not the
// same in every run.
struct cells cells_sort_atomic(const struct grid *grid,
                               struct points points, int threads);

// One count a cell and thread, so as many 32-bit numbers more. The
// same as cells_sort, for any number of threads; threads >= 1.
struct cells cells_sort_private(const struct grid *grid,
                                struct points points, int threads);

// Counts by shares of the points, one for each thread, in m bands of
// 1 << shift cells. Writes every point's cell to home[0 .. n-1], and to
// count[k * m + b] how many of share k's points are in band b.
void count_shares(const struct grid *grid, struct points points,
                  int shares, int shift, uint32_t m, uint32_t *home,
                  uint32_t *count);

// Turns these counts into the place of the first of them, all bands in
// order, and in a band all shares in order. start[0 .. m] is where the
// bands begin.
void scan_shares(uint32_t *count, uint32_t m, int shares,
                 uint32_t *start);
//<

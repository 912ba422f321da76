//> Declare the sorts by shared counts
// Two ways to let threads count and place the points of chapter 4's
// sort: all of them in the same counts, atomically, or each in its own
// (Zagha and Blelloch 1991, for the lanes of a Cray).
#pragma once
#include "ch04-cell-sort/cells.h"

// One count a cell, shared by all threads. Inside a cell the points
// stand in the order in which the threads took places: not
// cells_sort's, and not the same in every run.
struct cells cells_sort_atomic(const struct grid *grid,
                               struct points points, int threads);

// One count a cell and thread, so as many 32-bit numbers more. The
// same as cells_sort, for any number of threads; threads >= 1.
struct cells cells_sort_private(const struct grid *grid,
                                struct points points, int threads);

// Turns counts into places: count[k * m + b] is how many of chunk k's
// points are in bucket b, of m, and becomes the place of the first of
// them, all buckets in order, and in a bucket all chunks in order.
// start[0 .. m] is where the buckets begin. A bucket is a cell, or
// many.
void scan_chunks(uint32_t *count, uint32_t m, int chunks,
                 uint32_t *start);
//<

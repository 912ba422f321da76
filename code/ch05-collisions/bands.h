//> Declare the sort by bands
// Chapter 4's sort for any number of threads, and always the same
// result: first by bands of cells, a few rows of the grid each, every
// thread with counts of its own for the bands; then every band by
// itself, by one thread and inside its cache.
#pragma once
#include "ch04-cell-sort/cells.h"

// The same as cells_sort, bit for bit; threads >= 1. Needs 12 bytes a
// point beyond the result while it runs: 18 in all at two points a
// cell.
struct cells cells_sort_threads(const struct grid *grid,
                                struct points points, int threads);

// All nearest neighbors, every step by all threads.
void cells_threads(const struct question *question,
                   struct answers *answers);
//<

//> Declare the search in batches of four
// The nearest neighbors of points that are sorted by cell. Points that
// follow each other in a row of cells have nearly the same block, so
// four of them are searched for as one batch, each in a vector lane of
// its own: a candidate is loaded once for all four, and the cells of a
// row of the block, neighbors in the sorted arrays, are one loop. About
// 9 c + 10 distances a point, c points in a cell; threads share out the
// rows.
#pragma once
#include "ch04-cell-sort/sorted.h"

// On average, where this search is fast and the cells are few.
enum { POINTS_PER_CELL = 2 };

// Nearest only; sorted holds the question's points.
void search_batches(const struct question *question,
                    const struct sorted *sorted,
                    struct answers *answers);

// The row of the table: sorts on one thread, and searches.
search_function cells_batched;
//<

//> Declare the search that asks together
// The nearest neighbors of points that are sorted by cell. Points that
// follow each other in a row of cells have nearly the same block, so
// four of them ask together, each in a vector lane of its own, and
// every candidate is loaded once for all of them; the cells of one row
// of the block are neighbors in the sorted arrays, and are gone through
// as one. About 9 c + 9 distances a point, c points in a cell; threads
// share out the rows.
#pragma once
#include "ch04-cell-sort/sorted.h"

// On average, where this search is fastest.
enum { POINTS_PER_CELL = 2 };

// Nearest only; sorted holds the question's points.
void search_together(const struct question *question,
                     const struct sorted *sorted,
                     struct answers *answers);

// Sorts the points in this way, and searches.
void sort_and_search(const struct question *question, cell_sort *sort,
                     struct answers *answers);

// Sorts them on one thread.
void cells_together(const struct question *question,
                    struct answers *answers);
//<

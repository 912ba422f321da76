//> Declare the search that asks together
// The nearest neighbors of points that are sorted by cell. Points that
// follow each other in a row of cells have nearly the same block, so
// four of them ask together, each in a vector lane of its own, and
// every candidate is loaded once for all of them; the cells of one row
// of the block are neighbors in the sorted arrays, and are gone through
// as one. About 9 c + 9 distances a point, c points in a cell; threads
// share out the rows.
#pragma once
#include "ch04-cell-sort/cells.h"

// On average, where this search is fastest.
enum { POINTS_PER_CELL = 2 };

// Nearest only; sorted are the question's points in the order of the
// cells, as points_in_order gives them.
void search_together(const struct question *question,
                     const struct grid *grid, const struct cells *cells,
                     struct points sorted, struct answers *answers);

// Sorts the points into cells, and searches.
void cells_together(const struct question *question,
                    struct answers *answers);
//<

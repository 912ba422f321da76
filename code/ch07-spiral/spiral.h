//> Declare the spiral search
// The nearest neighbor of every point by a spiral search
// (spiral_search.h) through the points sorted by cell, as indices. The
// expected number of distances a point does not depend on n; of points
// that are all in one cell, every pair is compared.
#pragma once
#include "ch04-cell-sort/cells.h"

// The row of the table: sorts, and searches.
search_function spiral;

// The search alone. order[0 .. n-1]: the queries, in the order in which
// they are made; NULL: that of the input.
void search_spiral(const struct question *question,
                   const struct grid *grid, const struct cells *cells,
                   const uint32_t *order, struct answers *answers);
//<

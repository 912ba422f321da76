//> Declare the spiral search
// The nearest neighbor of every point by a spiral search (seek.h)
// through the points sorted by cell, as indices. The expected number of
// distances a point does not depend on n (expected.h); threads share
// out the points.
#pragma once
#include "ch04-cell-sort/cells.h"

// The row of the table: sorts, and searches.
search_function spiral;

// The search alone. The points ask in the order given, all n of them;
// NULL: as they come.
void search_spiral(const struct question *question,
                   const struct grid *grid, const struct cells *cells,
                   const uint32_t *order, struct answers *answers);
//<

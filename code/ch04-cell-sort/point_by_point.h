//> Declare the searches point by point
// The nearest neighbor of every point from the block of cells around
// it, which is widened until nothing outside can be nearer. About 9 c
// distances a point, c points in a cell; threads share out the points.
// Three ways to hold the cells, and one search that errs.
#pragma once
#include "ch04-cell-sort/lists.h"
#include "ch04-cell-sort/sorted.h"

// The rows of the table: make the structure, search, nearest only.
search_function cells_lists, cells_indices, cells_sorted;

// The searches alone. The points ask in the order given, all n of them;
// NULL: as they come.
void search_lists(const struct question *question,
                  const struct grid *grid, const struct lists *lists,
                  const uint32_t *order, struct answers *answers);
void search_indices(const struct question *question,
                    const struct grid *grid, const struct cells *cells,
                    const uint32_t *order, struct answers *answers);

// The points ask in the order of the cells.
void search_sorted(const struct question *question,
                   const struct sorted *sorted,
                   struct answers *answers);

// Its counting twin, for whoever cuts a grid of his own: take the
// counts with counting_take.
void counting_search_sorted(const struct question *question,
                            const struct sorted *sorted,
                            struct answers *answers);

// Looks at the nine cells and no further: wrong now and then. Who finds
// nobody is given NOBODY, at INFINITY.
void search_untested(const struct question *question,
                     const struct sorted *sorted,
                     struct answers *answers);
//<

//> Declare the searches point by point
// The nearest neighbor of every point from the block of cells around
// it, which is widened until no point outside can be nearer. About 9 c
// distances a point, c points in a cell; threads share out the points.
// The same search for three ways to store the cells.
#pragma once
#include "ch04-cell-sort/lists.h"
#include "ch04-cell-sort/sorted.h"

// The rows of the table: make the structure, search, nearest only.
search_function cells_lists, cells_indices, cells_sorted;

// The searches alone. order[0 .. n-1] says in which order the points
// are queries; NULL: as they come.
void search_lists(const struct question *question,
                  const struct grid *grid, const struct lists *lists,
                  const uint32_t *order, struct answers *answers);
void search_indices(const struct question *question,
                    const struct grid *grid, const struct cells *cells,
                    const uint32_t *order, struct answers *answers);

// In the order of the cells.
void search_sorted(const struct question *question,
                   const struct sorted *sorted,
                   struct answers *answers);
//<

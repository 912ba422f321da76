//> Declare the cells
// The points sorted by cell: an array of point numbers, grouped by cell
// (Su, figure 3). n + m steps and as many 32-bit numbers for n points
// in m cells. Inside a cell the lowest index comes first, whoever does
// the sorting.
#pragma once
#include "ch04-cell-sort/grid.h"

struct cells {
    uint32_t *start; // start[0 .. m]: cell k holds the points
    uint32_t *point; // point[start[k]] .. point[start[k + 1] - 1]
};

// Released with cells_free.
struct cells cells_sort(const struct grid *grid, struct points points);
void cells_free(struct cells *cells);

// The points themselves in this order: a copy, to be released with
// points_free.
struct points points_in_order(struct points points,
                              const uint32_t *order);
//<

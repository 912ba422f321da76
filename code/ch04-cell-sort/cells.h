//> Declare the cells
// The points sorted by cell: an array of indices, grouped by cell
// (Su, figure 3). n + m steps and n + m + 1 32-bit numbers for n points
// in m cells. Inside a cell the lowest index comes first, in whatever
// way it was sorted.
#pragma once
#include "ch04-cell-sort/grid.h"

//> Declare the sorted cells
struct cells {
    uint32_t *start; // start[0 .. m]: cell k holds the points
    uint32_t *point; // point[start[k]] .. point[start[k + 1] - 1]
};
//<

// Released with cells_free.
struct cells cells_sort(const struct grid *grid, struct points points);
void cells_free(struct cells *cells);

// For other ways to sort: room for n points in m cells, all counts 0;
// and the scan, which turns the counts of m cells into the places where
// they begin, the first of them at first.
struct cells cells_allocate(uint32_t m, uint32_t n);
void cells_scan(uint32_t *count, uint32_t m, uint32_t first);
//<

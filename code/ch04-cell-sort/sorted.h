//> Declare the sorted points
// The points of a question sorted by cell: the grid, the indices of the
// points of each cell, and the points themselves in this order. With it
// a search has all that it needs.
#pragma once
#include "ch04-cell-sort/cells.h"

//> Hold the points in order of the cells
struct sorted {
    struct grid grid;
    struct cells cells;
    struct points points; // in the order of the cells
};
//<

// Fits a grid with c points in a cell on average, c > 0, sorts on one
// thread and copies the points. Released with sorted_free.
struct sorted sorted_make(const struct question *question, double c);
void sorted_free(struct sorted *sorted);

// The points in this order: a copy, made by so many threads, to be
// released with points_free.
struct points points_in_order(struct points points,
                              const uint32_t *order, int threads);
//<

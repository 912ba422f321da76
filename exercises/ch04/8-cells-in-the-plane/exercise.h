// Exercise: cells in the plane
#pragma once
#include "common/points.h"

// Cells of one size on the unit square, numbered row by row.
struct grid {
    uint32_t columns, rows;
};

// The cell of a point of the unit square, its borders included.
static inline uint32_t cell_at(struct grid grid, double x, double y)
{
    uint32_t column = (uint32_t)(x * grid.columns);
    uint32_t row = (uint32_t)(y * grid.rows);
    if (column == grid.columns)
        column--;
    if (row == grid.rows)
        row--;
    return row * grid.columns + column;
}

// The points in the order of their cells, the lowest index first in
// each. Cell k has the places start[k] to start[k + 1] - 1; start has
// an element more than there are cells. In place s stands the point
// that was number index[s], with its coordinates.
struct sorted {
    uint32_t *start;
    double *x, *y;
    uint32_t *index;
};

// Sorts the points into arrays that the caller has allocated.
void sort_into_cells(struct points points, struct grid grid,
                     struct sorted *sorted);

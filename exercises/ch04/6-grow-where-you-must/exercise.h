// Exercise: grow where you must
#pragma once
#include <stdint.h>

// Column c holds the points with column_border[c] <= x <
// column_border[c + 1], the last one also those on the last border;
// rows likewise.
struct grid {
    uint32_t columns, rows;
    const double *column_border; // [0 .. columns], rising
    const double *row_border;    // [0 .. rows], rising
};

#define NO_INDEX UINT32_MAX
struct found {
    uint32_t nearest; // NO_INDEX: none
    double nearest2;  // its squared distance; INFINITY: none
};

// The nearest point in a cell, the lowest index if several tie, without
// the query. Given; it counts.
struct found look(uint32_t column, uint32_t row);

// The nearest neighbor of the query, at (x, y) in the cell (column,
// row); the lowest index if several tie.
struct found grow(const struct grid *grid, uint32_t column,
                  uint32_t row, double x, double y);

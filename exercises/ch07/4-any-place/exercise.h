// Exercise: a query anywhere
#pragma once
#include <stdint.h>

// Column c holds the points with column_border[c] <= x <
// column_border[c + 1], the last one also those on the last border;
// rows likewise. No point lies outside.
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

// The point of a cell that is nearest to the query, the lowest index
// if several tie. Given; it counts.
struct found look(uint32_t column, uint32_t row);

// The point nearest to a query at (x, y), which may be anywhere;
// the lowest index if several tie. There is a point.
struct found nearest_point(const struct grid *grid, double x, double y);

// Exercise: one block, many queries
#pragma once
#include <stdint.h>

// Points in the order of their cells: cell k, which is row * columns +
// column, has the places from start[k] up to, not including,
// start[k + 1], and at place s is the point (x[s], y[s]).
struct sorted {
    uint32_t columns, rows;
    const uint32_t *start; // [0 .. columns * rows]
    const double *x, *y;   // [0 .. n-1], n = start[columns * rows]
};

// For each place s, sets nearest2[s] to the least squared distance,
// dx * dx + dy * dy, from its point to another one in its block: its
// own cell and the cells beside it, up to eight, as far as the grid
// has them. INFINITY if there is no other. No cell has more than 64
// points.
void nearest_in_block(const struct sorted *sorted, double *nearest2);

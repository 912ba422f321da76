// Exercise: once around
#pragma once
#include <stdbool.h>
#include <stdint.h>

struct cell {
    uint32_t column, row;
};

struct grid {
    uint32_t columns, rows;
    bool wraps; // the last column is beside the first, rows likewise
};

// Writes the cells of layer k around home to cells, in any order, each
// once, and returns how many they are. There is room for 8 k of them,
// for one if k is 0, and never for more than the grid has.
uint32_t layer(const struct grid *grid, struct cell home, uint32_t k,
               struct cell *cells);

// Exercise: not the inside
#pragma once
#include <stdbool.h>
#include <stdint.h>

// Whether the point at a place of the sorted points lies in the box.
// Given; it counts.
bool is_in_box(uint32_t place);

// The cells that a box meets: these columns and rows, the last ones
// included. Where it begins and ends inside of a cell, that cell is the
// first or the last.
struct cell_block {
    uint32_t first_column, last_column, first_row, last_row;
};

// How many points lie in the box. The cell in column i and row j is
// number j * columns + i, and has the places start[number] to
// start[number + 1] - 1.
uint32_t count_in_box(const uint32_t *start, uint32_t columns,
                      struct cell_block block);

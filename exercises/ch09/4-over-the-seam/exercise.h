// Exercise: over the seam
#pragma once
#include <stdint.h>

// The points of the cell in column c and row r have the places from
// start[k] up to, not including, start[k + 1], where k is
// r * columns + c.
struct grid {
    uint32_t columns, rows;
    const uint32_t *start; // [0 .. columns * rows]
};

struct span {
    uint32_t begin, end; // places, the end not included
};

// Columns or rows, both ends included.
struct stretch {
    uint32_t first, last;
};

// Given. Which of so many columns, or rows, are at most reach away from
// one of them, around the edges: one stretch or two, in ascending
// order. Returns how many.
uint32_t stretches(uint32_t at, uint32_t reach, uint32_t count,
                   struct stretch *to);

// Writes where the points are in the cells at most reach columns and at
// most reach rows away from home, on a grid that wraps around: as few
// spans as possible, in ascending order. Returns how many. There is
// room for two spans for each row of the block.
uint32_t block_spans(const struct grid *grid, uint32_t column,
                     uint32_t row, uint32_t reach, struct span *spans);

// Exercise: back in order
#pragma once
#include <stdint.h>

// The cell, 0 .. m-1, of the point that stands in a slot now. Given; it
// counts.
uint32_t cell_of(uint32_t slot);

// Exchanges the points of two slots. Given; it counts.
void exchange(uint32_t s, uint32_t t);

// Brings the points of slots 0 .. n-1 into the order of their cells, m
// >= 1 of them, in no order inside a cell. Cell k then stands in the
// slots start[k] .. start[k + 1] - 1.
void back_in_order(uint32_t n, uint32_t m, uint32_t *start);

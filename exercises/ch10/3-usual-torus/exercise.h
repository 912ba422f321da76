// Exercise: the usual torus
#pragma once
#include <stdint.h>

// The box is columns by rows cells with side 1, and wraps around.
struct box {
    uint32_t columns, rows;
};

// The places from begin up to, not including, end.
struct span {
    uint32_t begin, end;
};

// Given. The points of a cell. It counts.
struct span look(uint32_t column, uint32_t row);

// Given. The squared distance, on the usual torus, of the point at a
// place from the query. It counts.
double measure(uint32_t place);

// The place of the furthest point from (x, y), the lowest if several
// tie. 0 <= x < columns, 0 <= y < rows, and there is a point.
uint32_t furthest_on_torus(struct box box, double x, double y);

// Exercise: on the move
#pragma once
#include "common/points.h"

#define NONE UINT32_MAX

// The box is columns by rows cells with side 1, from (0, 0) on. Cell k
// is in column k % columns and row k / columns.
struct box {
    uint32_t columns, rows;
};

// Given. The cell that point i is kept in, NONE before it was put.
uint32_t kept_in(uint32_t i);

// Given. Takes point i out of the cell that it is kept in, and puts it
// into another. It counts.
void put(uint32_t i, uint32_t cell);

// Given. The first point kept in a cell, and the one after point i in
// the same cell; NONE if there is none.
uint32_t first_in(uint32_t cell);
uint32_t next_to(uint32_t i);

// Given. The squared distance of two points. It counts.
double measure(struct points points, uint32_t i, uint32_t j);

// Called after every step, with the points where they are now.
void keep_up(struct points points, struct box box);

// The nearest neighbor of point i among n >= 2, the lowest index if
// several tie.
uint32_t nearest_now(struct points points, struct box box, uint32_t i);

// Exercise: the innermost loop
#pragma once
#include <stdint.h>

// The first lanes elements of task and cell are what is still to be
// done; place and keep have room for as many and belong to you.
struct strip {
    uint32_t lanes, *task, *cell, *place;
    uint8_t *keep;
};

// Given: lane l measures how far the point of task[l] is from the one
// at place[l], and keeps the nearest. Costs 1 for each lane.
void measure(uint32_t lanes, const uint32_t *task,
             const uint32_t *place);

// Given: moves those values[l] whose keep[l] is 1, not 0, to the front,
// in order, and returns how many they are. Costs 1 for each lane.
uint32_t pack(uint32_t lanes, const uint8_t *keep, uint32_t *values);

// Compares every task with all points of its cell, once each. Cell k
// has the places from start[k] up to, not including, start[k + 1].
void look_into_cells(struct strip *strip, const uint32_t *start);

// Exercise: when to pack
#pragma once
#include <stdint.h>

// Given: a step of every lane, finished or not; returns how many lanes
// have still work to do. Costs 1 for each lane.
uint32_t step(void);

// Given: removes the finished lanes. Costs the price of a pack for each
// lane that there is when it begins.
void pack(void);

// Steps until all tasks are finished, one in each lane at first.
void work_off(uint32_t lanes, uint32_t price);

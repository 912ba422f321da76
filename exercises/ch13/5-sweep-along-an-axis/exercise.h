// Exercise: sweep along an axis
#pragma once
#include <stdbool.h>
#include <stdint.h>

// All three are given, and count.
// Along x: below 0 if box i begins before box j, above 0 if after it, 0
// if both begin at the same place.
int compare_begins(uint32_t i, uint32_t j);
// Along x: whether box j begins before box i ends, or just there.
bool begins_within(uint32_t i, uint32_t j);
// Whether they meet along the two other axes.
bool meet_across(uint32_t i, uint32_t j);

struct pair {
    uint32_t one, other; // two boxes
};

// All pairs of the boxes 0 to n - 1 that meet along all three axes,
// each once, in any order. Returns how many there are. There is room
// for all pairs of n boxes, and for an order of n boxes to work with.
uint32_t find_pairs(uint32_t n, uint32_t *order, struct pair *pair);

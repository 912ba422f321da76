// Exercise: the nearest pair
#pragma once
#include "common/points.h"

struct pair {
    uint32_t i, j; // i < j
    double distance2;
};

// The two points of n >= 2 with the smallest distance, squared. Of
// several such pairs the one with the lowest i, and of those the one
// with the lowest j.
struct pair nearest_pair(struct points points);

// Exercise: the nearest pair, in parallel
#pragma once
#include <stdint.h>

// The squared distance of points i and j. Given; it may be called from
// any thread, and takes notes.
double measure(uint32_t i, uint32_t j);

struct pair {
    uint32_t i, j; // i < j
    double distance2;
};

// The nearest pair of n >= 2 points, found by so many threads. Ties:
// the lowest i, and of those the lowest j.
struct pair nearest_pair(uint32_t n, int threads);

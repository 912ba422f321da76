// Exercise: no further than necessary
#pragma once
#include <stdint.h>

// The squared distance of the points i and j. Given; it counts.
double measure(uint32_t i, uint32_t j);

// The nearest neighbor of point i among n >= 2, of which we know the x;
// the lowest index if several tie.
uint32_t nearest_early(uint32_t n, const double *x, uint32_t i);

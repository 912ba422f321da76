// Exercise: no further than necessary
#pragma once
#include "common/points.h"

// The squared distance of the points i and j. Given; it counts.
double measure(struct points points, uint32_t i, uint32_t j);

// The nearest neighbor of point i among n >= 2; the lowest index if
// several tie.
uint32_t nearest_early(struct points points, uint32_t i);

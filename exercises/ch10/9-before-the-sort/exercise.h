// Exercise: before the sort
#pragma once
#include "common/points.h"

// Writes to kept, in any order, the indices of some of n >= 1 points,
// each once, and returns how many. Among them are all corners of the
// convex hull; where several points are on a corner, the lowest index.
// kept has room for n indices. Coordinates are whole numbers of at most
// 2^20, so that sums and products of two are exact.
uint32_t throw_away(struct points points, uint32_t *kept);

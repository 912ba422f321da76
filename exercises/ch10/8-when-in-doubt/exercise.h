// Exercise: when in doubt
#pragma once
#include "common/geometry.h"
#include "common/points.h"

// Writes to kept, in any order, the indices of some of n >= 1 points,
// and returns how many. Among them are the answers of all queries: for
// each point i the point j for which distance2(xj - xi, yj - yi), as
// computed, is greatest, and if several tie that of the lowest index.
// kept has room for n indices. Coordinates are from -1e100 to 1e100,
// and the sides of the box around the points are 0 or at least 1e-100.
uint32_t keep_furthest(struct points points, uint32_t *kept);

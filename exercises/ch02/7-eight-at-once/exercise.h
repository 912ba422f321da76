// Exercise: eight at once
#pragma once
#include "common/points.h"

// For every point of one set, the squared distance to the nearest point
// of the other, as distance2 of common/geometry.h computes it. The
// other set has a point at least, and all squares are finite.
void nearest_in(struct points from, struct points to, double *nearest2);

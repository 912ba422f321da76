// Exercise: points in a ring
#pragma once
#include "common/points.h"

// Sets all coordinates to points of the ring around the origin with
// these radii, 0 <= inner < outer, evenly by area. The same seed gives
// the same points.
void fill_ring(struct points points, double inner, double outer,
               uint64_t seed);

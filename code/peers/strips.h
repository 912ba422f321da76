// An order that suits every search and any distribution: the points cut
// into strips of equally many, from left to right, and each strip
// sorted from bottom to top. About sqrt(n) strips of sqrt(n) points:
// what is near in the plane is near in the arrays.
#pragma once
#include "common/points.h"

// The points in this order: a copy, to be released with points_free.
struct points points_in_strips(struct points points);

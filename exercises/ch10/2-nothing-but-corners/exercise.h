// Exercise: nothing but corners
#pragma once
#include "common/points.h"

// Given. Writes the indices of all points to order: by x, then by y,
// then by index.
void sort_by_x(struct points points, uint32_t *order);

// Given. Greater than 0 if the way from point i by j to k turns left,
// less if it turns right, 0 if it does neither. It counts.
double turn(struct points points, uint32_t i, uint32_t j, uint32_t k);

// Given. The squared distance of two points. It counts.
double measure(struct points points, uint32_t i, uint32_t j);

// Writes the corners of the hull of n >= 1 points to corner, which has
// room for n + 1 indices, and returns how many they are. Both arrays
// are the caller's, who frees them. Scratch memory is allowed: free
// what you allocate.
uint32_t find_corners(struct points points, uint32_t *corner);

// The furthest point from point i, the lowest index if several tie.
// The points are not all in one place.
uint32_t furthest(struct points points, const uint32_t *corner,
                  uint32_t count, uint32_t i);

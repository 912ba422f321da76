// Exercise: all pairs within reach
#pragma once
#include "common/geometry.h"
#include "common/points.h"

// The squared distance of two points, in the wraparound geometry.
// Given; it counts.
double measure(uint32_t i, uint32_t j);

// Takes a pair of points that are closer than r. Given.
void take_pair(uint32_t i, uint32_t j);

// Hands every pair closer than r > 0 to take_pair(), once. The points lie
// from 0 to space.width and from 0 to space.height.
void pairs_within(struct points points, struct space space, double r);

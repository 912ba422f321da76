// Exercise: the shortest arc
#pragma once
#include <stdint.h>

struct arc {
    double start, length;
};

// The shortest piece of a circle of circumference 1 that holds the
// points at x[0] to x[n-1], all in [0, 1), n >= 1. It begins at one of
// them and runs upward, across the border if need be. x is not changed.
struct arc shortest_arc(const double *x, uint32_t n);

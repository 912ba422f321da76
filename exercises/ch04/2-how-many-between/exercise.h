// Exercise: how many between?
#pragma once
#include <stdint.h>

// Numbers sorted by bin. Bin k holds the x with border[k] <= x <
// border[k + 1], the last one also border[count], in the places
// start[k] .. start[k + 1] - 1, in no order.
struct bins {
    uint32_t count;        // of bins, >= 1
    const double *border;  // border[0 .. count], rising
    const uint32_t *start; // start[0 .. count]
};

// The bin of an x from border[0] to border[count]. Given.
uint32_t bin_of(const struct bins *bins, double x);

// The number in a place. Given; it counts.
double look(uint32_t place);

// How many numbers lie in [a, b).
uint32_t count_between(const struct bins *bins, double a, double b);

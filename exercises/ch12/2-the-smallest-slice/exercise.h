// Exercise: the smallest slice
#pragma once
#include <stdint.h>

// The number at a place of the order of a coordinate, the lowest at
// place 0. Given; it counts.
double number_at(int axis, uint32_t place);

struct axis_slice {
    int axis;            // the coordinate
    uint32_t begin, end; // places begin to end - 1 of its order
};

// Of n points in d dimensions, the places whose numbers lie in the box,
// low[k] <= number <= high[k], in the coordinate with the fewest; of
// equally few the lowest coordinate. low[k] <= high[k].
struct axis_slice smallest_slice(uint32_t n, int d, const double *low,
                                 const double *high);

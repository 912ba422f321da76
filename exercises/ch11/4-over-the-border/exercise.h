// Exercise: over the border
#pragma once
#include <stdint.h>

// A point of one half: where it is, and the squared distance to its
// nearest neighbor in the same half.
struct halved {
    double x, y, nearest2;
};

// The squared distance of point i of the left half and point j of the
// right half. Given; it counts.
double measure(uint32_t i, uint32_t j);

// Joins two halves, each sorted by y, with 2 points or more, none two
// in one place. All x on the left are less than border, and none on the
// right is. Sets every nearest2 to the squared distance of the nearest
// neighbor in both halves.
void join(struct halved *left, uint32_t lefts, struct halved *right,
          uint32_t rights, double border);

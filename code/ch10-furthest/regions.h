//> Declare the regions
// Of all corners of the hull only a few can be the furthest of anybody
// in a small part of the plane, and mostly a single one. So the box of
// the corners is cut into regions, and each knows its own. A point
// looks its region up and has its furthest, or a short list to compare.
// About one distance a point, if the points are spread evenly; on a
// circle of n points some sqrt(n).
#pragma once
#include "ch10-furthest/hull.h"
#include <stddef.h>

struct regions {
    double left, bottom; // region (x - left) * across, and so on,
    double across, up;   // each rounded down
    uint32_t side;       // as many rows, and columns
    uint32_t corners;    // how many there are
    uint32_t *region;    // row by row: the only corner, or where in
                         // the lists, counted from corners on, ...
    uint32_t *list;      // ... are how many, and their numbers
    size_t length, room; // of all lists
};

// For n points in the box of these corners. Released with
// regions_free.
struct regions regions_make(const struct corners *corners, uint32_t n);
void regions_free(struct regions *regions);

// The furthest of the corners for every point of the question, by its
// threads.
void search_regions(const struct question *question,
                    const struct corners *corners,
                    const struct regions *regions,
                    struct answers *answers);
//<

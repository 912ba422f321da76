//> Declare the candidate grid
// Of all corners of the hull only a few can be the furthest of any
// point in a small part of the plane, and mostly a single one. So the
// box of the corners is cut into cells, and each knows its candidates.
// A point looks its cell up and has its furthest, or a short list to
// compare. About one distance a point, if the points are spread evenly;
// on a circle of n points some sqrt(n).
#pragma once
#include "ch10-furthest/hull.h"
#include "common/workspace.h"

//> Hold a candidate grid
struct candidate_grid {
    double left, bottom; // cell (x - left) * across, and so on,
    double across, up;   // each rounded down
    uint32_t side;       // as many rows, and columns
    uint32_t corners;    // how many there are
    uint32_t *cell;      // row by row: the only corner, or where in
                         // the lists, counted from corners on, ...
    uint32_t *list;      // ... are how many, and their numbers
    size_t length, room; // of all lists
};
//<

// For n points in the box of these corners. All arrays are taken from
// the workspace.
struct candidate_grid candidate_grid_make(const struct corners *corners,
                                          uint32_t n,
                                          struct workspace *workspace);
//<

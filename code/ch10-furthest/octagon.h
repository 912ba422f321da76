//> Declare the octagon
// The extreme points in eight directions. Nearly all points are inside
// the octagon between them, and no corners of the hull (Akl and
// Toussaint 1978). Two passes over the points, no memory of their size.
#pragma once
#include "common/points.h"
#include "common/workspace.h"

enum { EXTREMES = 8 };

//> Hold the sides of the octagon
// A point at (x, y) from the low corner of the box lies deeper inside
// than the margin if a x + b y > c for all eight. Then its surplus is
// the square of the margin at least: it is the middle between two
// points of the octagon that are as far away as that.
struct sides {
    double left, bottom, diagonal2;
    double a[EXTREMES], b[EXTREMES], c[EXTREMES];
};
//<

// The sides of the octagon of these points, found by so many threads;
// diagonal2 is that of their box, squared.
struct sides octagon_sides(struct points points, int threads);

// The points that are outside, or not deeper inside than the margin:
// writes their indices to kept, which has room for all, in ascending
// order, and returns how many.
uint32_t octagon_outside(struct points points,
                         const struct sides *sides, int threads,
                         struct workspace *workspace, uint32_t *kept);
//<

//> Declare the bounds of a box
// How near, and with the furthest image how far, a point in a box can
// be. What is computed here for an edge of the box is rounded as for a
// point, and rounding keeps order: no point in the box is better than
// the bound, in computed distances.
#pragma once
#include "ch02-all-pairs/pair.h"
#include "ch11-crowds/cut.h"
#include "common/min_max.h"

//> Bound the separation along an axis
// The least between x and the stretch from low to high, and the most.
INLINED double min_separation(const enum geometry geometry,
                              double period, double low, double high,
                              double x)
{
    double gap = MAX(low - x, x - high);
    if (geometry == WRAPAROUND)
        gap = MIN(gap, period - MAX(x - low, high - x));
    return gap > 0 ? gap : 0;
}

INLINED double max_separation(const enum geometry geometry,
                              double period, double low, double high,
                              double x)
{
    const double most = MAX(x - low, high - x);
    if (geometry == STANDARD)
        return most;
    const double gap = MAX(low - x, x - high);
    return MAX(most, period - (gap > 0 ? gap : 0));
}
//<

//> Bound what a box can give
// A squared distance, negative if the furthest is looked for: then the
// less, the better, either way. Nothing is expected of an empty box.
INLINED double box_bound(const enum geometry geometry,
                         const bool furthest, struct space space,
                         const struct box *box, double x, double y)
{
    if (box->left > box->right)
        return INFINITY;
    if (furthest)
        return -distance2(max_separation(geometry, space.width,
                                         box->left, box->right, x),
                          max_separation(geometry, space.height,
                                         box->bottom, box->top, y));
    return distance2(
        min_separation(geometry, space.width, box->left, box->right, x),
        min_separation(geometry, space.height, box->bottom, box->top,
                       y));
}
//<

//> Find how far a box reaches
// The squared distance to its furthest corner, without wraparound.
static inline double box_far2(const struct box *box, double x, double y)
{
    return distance2(
        max_separation(STANDARD, 0, box->left, box->right, x),
        max_separation(STANDARD, 0, box->bottom, box->top, y));
}
//<
//<

//> Declare the corners
// In the standard geometry only a corner of the convex hull can be
// somebody's furthest point. Distances are rounded, so whoever could be
// the furthest in rounded distances counts as a corner, too. An octagon
// throws away most of the others, a chain (Andrew 1979) finds the
// corners among the rest: about n steps as long as few points are
// outside the octagon, else n log n.
#pragma once
#include "common/question.h"

struct corners {
    struct points points; // where they are
    uint32_t *point;      // who they are, in ascending order
};

// A point is nobody's furthest if it is the mean of others, with any
// weights, and their mean squared distance from it is more than this
// times that of the diagonal of the box of all points.
static const double CORNER_SURPLUS = 0x1p-44;

// Where the squared diagonal is between these, what we compute from it
// neither vanishes nor overflows.
static const double LEAST_D2 = 0x1p-900, MOST_D2 = 0x1p+1000;

// Whoever is the furthest of any of the points, in rounded squared
// distances and of several the one of the lowest index, is among them;
// but where all squared distances of the box vanish or overflow, all
// points are. By the question's threads; its geometry must be
// standard. Released with corners_free.
struct corners corners_find(const struct question *question);
void corners_free(struct corners *corners);

// The same of these points, called who[0 .. points.n-1], or by their
// own indices if who is NULL.
struct corners corners_among(struct points points, const uint32_t *who,
                             int threads);
//<

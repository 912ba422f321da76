//> Declare the corners
// In the standard geometry only a corner of the convex hull can be the
// furthest of any point. Distances are rounded, so a point that could
// be the furthest in rounded distances counts as a corner, too. An
// octagon throws away most of the others, a chain (Andrew 1979) finds
// the corners among the rest: about n steps as long as few points are
// outside the octagon, else n log n.
#pragma once
#include "common/question.h"
#include "common/workspace.h"

//> Hold the corners
struct corners {
    struct points points; // where they are
    uint32_t *point;      // their indices, in ascending order
};
//<

//> Ask for so much surplus
// A point is never the furthest if its surplus is more than this, times
// D^2, where D is the diagonal of the box of all points. Two squared
// distances are compared, each with an error below 2^-50 D^2, and a
// mean that we compute misses the point by less than 2^-47 D, twice
// the MISS of hull.c: half would do.
static const double CORNER_SURPLUS = 0x1p-44;
//<

//> Trust what neither vanishes nor overflows
// Where the squared diagonal is between these, what we compute from it
// neither vanishes nor overflows.
static const double MIN_D2 = 0x1p-900, MAX_D2 = 0x1p+1000;
//<

// The furthest of every point, in rounded squared distances and of
// several the one of the lowest index, is among them; but where all
// squared distances of the box vanish or overflow, all points are. By
// the question's threads; its geometry must be standard. All memory is
// taken from the workspace, where the caller keeps a mark.
struct corners corners_find(const struct question *question,
                            struct workspace *workspace);

// The same of these points alone, whose indices among all points are
// given; NULL: their own.
struct corners corners_among(struct corners points, int threads,
                             struct workspace *workspace);

// The same from left to right, and not by index; and then by index.
struct corners corners_from_left(struct corners points, int threads,
                                 struct workspace *workspace);
struct corners corners_by_index(struct corners corners,
                                struct workspace *workspace);

// Room for n corners, or points among which to look for them.
struct corners corners_take(uint32_t n, struct workspace *workspace);
//<

//> Declare the corners
// In the standard geometry only a corner of the convex hull can be
// somebody's furthest point. An octagon of extreme points (Akl and
// Toussaint 1978) throws away nearly all of those inside; a chain
// (Andrew 1979) finds the corners among the rest. Distances are
// rounded, so whoever could be the furthest in rounded distances counts
// as a corner, too. About n steps to find the corners, as long as few
// points are outside the octagon, else n log n; then n times as many
// distances as there are corners: n^2 on a circle.
#pragma once
#include "common/question.h"
#include <stdbool.h>

struct corners {
    struct points points; // where they are
    uint32_t *point;      // who they are, in ascending order
};

// Whoever is the furthest of any of the points, in rounded squared
// distances and of several the one of the lowest index, is among them;
// but where all squared distances of the box vanish or overflow, all
// points are. By the question's threads; its geometry must be
// standard. Released with corners_free.
struct corners corners_find(const struct question *question);
void corners_free(struct corners *corners);

// The furthest of these corners for every point of the question, by its
// threads.
void search_corners(const struct question *question,
                    const struct corners *corners,
                    struct answers *answers);

// The row of the table: finds the corners, and searches them.
void furthest_hull(const struct question *question,
                   struct answers *answers);
//<

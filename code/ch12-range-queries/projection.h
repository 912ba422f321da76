//> Declare the projection
// For each coordinate the points sorted by it, as references. Binary
// searches find the slice of the range in every coordinate; the points
// of the slice with the fewest are looked at (Bentley and Friedman,
// 1979).
#pragma once
#include "ch12-range-queries/scan.h"

//> Hold the projection
struct projection {
    struct point_set points;         // the caller's, not copied
    uint32_t *order[MAX_DIMENSIONS]; // order[k]: sorted by x[k]
};
//<

// The points stay the caller's, and where they are. Released with
// projection_free.
struct projection projection_make(const struct point_set *points);
void projection_free(struct projection *projection);
size_t projection_bytes(const struct projection *projection);

// The points have moved: repairs the order of each coordinate. Says how
// many shifts there were.
uint64_t projection_update(struct projection *projection);

void projection_query(const struct projection *projection,
                      const struct range *range, struct report *report);
//<

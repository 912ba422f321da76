//> Declare the scan
// Looks at all points: the bar that every structure must beat, and the
// last step of each of them.
#pragma once
#include "ch12-range-queries/point_set.h"

//> Report what a query finds
// One query after the other may add to the same report.
struct report {
    uint32_t *found; // indices of points, in any order; room for all
    uint32_t count;  // of them
    uint64_t steps;  // nodes, cells, or comparisons of a search
    uint64_t tested; // points whose coordinates were looked at
};
//<

//> Test one point
// Until a coordinate is outside.
static inline bool is_inside(const struct point_set *points, uint32_t i,
                             const struct range *range)
{
    for (int k = 0; k < points->d; k++) {
        const double x = points->x[k][i];
        if (x < range->low[k] || x > range->high[k])
            return false;
    }
    return true;
}
//<

// The points that are in the range: one after the other, until a
// coordinate is outside; or several at once.
void scan_points(const struct point_set *points,
                 const struct range *range, struct report *report);
void scan_lanes(const struct point_set *points,
                const struct range *range, struct report *report);

//> Declare points in order
// A structure keeps a copy of the points in an order of its own. Point
// s of them is point index[s] of those that it was built from.
struct sorted_points {
    struct point_set points;
    uint32_t *index;
};
//<

struct sorted_points sorted_points_allocate(uint32_t n, int d);
void sorted_points_free(struct sorted_points *sorted);
size_t sorted_points_bytes(const struct sorted_points *sorted);

// Copies to every place the point that belongs there.
void sorted_points_fill(struct sorted_points *sorted,
                        const struct point_set *points);

//> Hold a span
struct span {
    uint32_t begin, end; // places begin to end - 1
};
//<

// Reports the places begin to end - 1, all of them; or those that are
// in the range in the coordinates of a set, bit k for coordinate k.
void report_all(const struct sorted_points *sorted, uint32_t begin,
                uint32_t end, struct report *report);

//> Filter by some coordinates
struct filter {
    const struct range *range;
    unsigned axes; // the set of coordinates to be looked at
};
//<
void report_inside(const struct sorted_points *sorted, uint32_t begin,
                   uint32_t end, struct filter filter,
                   struct report *report);
//<

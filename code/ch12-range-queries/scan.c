//> Scan the points
// n points, d comparisons of two numbers each, or fewer: a point, or
// all points of a vector, may be outside by an early coordinate.
#include "ch12-range-queries/scan.h"
#include "common/allocate.h"
#include "common/min_max.h"
#include <stdlib.h>
#include <string.h>

//> Look at one point after the other
void scan_points(const struct point_set *points,
                 const struct range *range, struct report *report)
{
    for (uint32_t i = 0; i < points->n; i++)
        if (is_inside(points, i, range))
            report->found[report->count++] = i;
    report->tested += points->n;
}
//<

//> Test several points at once
// A lane is -1 as long as its point is inside, and becomes 0. Where all
// lanes are 0, no other coordinate is looked at. (Without the pragma
// gcc 12 unrolls the loop, and then finds no vectors in it.)
typedef int64_t lanes[LANES];

static inline int64_t test_lanes(const struct point_set *points,
                                 uint32_t i, struct filter filter,
                                 lanes inside)
{
    int64_t any = -1;
    for (int lane = 0; lane < LANES; lane++)
        inside[lane] = -1;
    for (int k = 0; k < points->d && any; k++) {
        if (!(filter.axes >> k & 1))
            continue;
        const double *x = points->x[k] + i;
        const double low = filter.range->low[k];
        const double high = filter.range->high[k];
        any = 0;
#pragma omp simd reduction(| : any)
        for (int lane = 0; lane < LANES; lane++) {
            inside[lane] &=
                -(int64_t)((x[lane] >= low) & (x[lane] <= high));
            any |= inside[lane];
        }
    }
    return any;
}
//<

//> Scan by lanes
void scan_lanes(const struct point_set *points,
                const struct range *range, struct report *report)
{
    const struct filter filter = {range, (1u << points->d) - 1};
    uint32_t *found = report->found, count = report->count;
    for (uint32_t i = 0; i < points->n; i += LANES) {
        lanes inside;
        if (!test_lanes(points, i, filter, inside))
            continue;
        const uint32_t some = MIN(points->n - i, LANES);
        for (uint32_t lane = 0; lane < some; lane++)
            if (inside[lane])
                found[count++] = i + lane;
    }
    report->count = count;
    report->tested += points->n;
}
//<

struct sorted_points sorted_points_allocate(uint32_t n, int d)
{
    return (struct sorted_points){point_set_allocate(n, d),
                                  allocate(n, sizeof(uint32_t))};
}

void sorted_points_free(struct sorted_points *sorted)
{
    point_set_free(&sorted->points);
    free(sorted->index);
}

size_t sorted_points_bytes(const struct sorted_points *sorted)
{
    return point_set_bytes(&sorted->points) +
           sorted->points.n * sizeof *sorted->index;
}

//> Bring the points into order
void sorted_points_fill(struct sorted_points *sorted,
                        const struct point_set *points)
{
    for (int k = 0; k < points->d; k++)
        for (uint32_t s = 0; s < points->n; s++)
            sorted->points.x[k][s] = points->x[k][sorted->index[s]];
}
//<

//> Report a span, tested or not
void report_all(const struct sorted_points *sorted, uint32_t begin,
                uint32_t end, struct report *report)
{
    memcpy(report->found + report->count, sorted->index + begin,
           (end - begin) * sizeof *sorted->index);
    report->count += end - begin;
}

void report_inside(const struct sorted_points *sorted, uint32_t begin,
                   uint32_t end, struct filter filter,
                   struct report *report)
{
    for (uint32_t s = begin; s < end; s += LANES) {
        lanes inside;
        if (!test_lanes(&sorted->points, s, filter, inside))
            continue;
        const uint32_t some = MIN(end - s, LANES);
        for (uint32_t lane = 0; lane < some; lane++)
            if (inside[lane])
                report->found[report->count++] =
                    sorted->index[s + lane];
    }
    report->tested += end - begin;
}
//<
//<

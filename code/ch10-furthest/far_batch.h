//> Declare a batch of far queries
// Queries for the furthest point, eight together, each in a lane, or a
// single one, and how they compare themselves with a point and with a
// cell. How many there are is a constant in each copy of a function.
#pragma once
#include "ch02-all-pairs/pair.h"
#include "ch04-cell-sort/block.h"
#include "ch04-cell-sort/sorted.h"
#include "common/workspace.h"

//> List the rows that have points
struct rows {
    uint32_t count, *row; // from below
    uint32_t *place;      // of a row in this list, if it is there
};

// Their arrays are taken from the workspace.
struct rows rows_find(const struct sorted *sorted,
                      struct workspace *workspace);
//<

//> Hold a batch of far queries
enum { FAR_BATCH = 8 };

struct far_scene {
    const struct sorted *sorted;
    const struct rows *rows; // that have points
    struct space space;
};

struct far_batch {
    double x[FAR_BATCH], y[FAR_BATCH], max2[FAR_BATCH];
    int64_t self[FAR_BATCH], furthest[FAR_BATCH]; // as wide as the rest
    struct counts *counts;                        // of the thread
};
//<

//> Guard a bound against rounding
// For bounds that are not computed as the distances are that they
// bound: a few roundings, each at most 2^-53, are far less than this.
#define ROUNDING_GUARD (1 + 0x1p-48)
//<

//> Begin a batch of far queries
// The queries of the sorted points from s on. As long as no point is
// further than 0, the first of the others is the furthest.
INLINED void begin_far_batch(const uint32_t lanes,
                             const struct sorted *sorted, uint32_t s,
                             struct far_batch *batch)
{
#pragma omp simd
    for (uint32_t lane = 0; lane < lanes; lane++) {
        int64_t self = sorted->cells.point[s + lane];
        batch->x[lane] = sorted->points.x[s + lane];
        batch->y[lane] = sorted->points.y[s + lane];
        batch->max2[lane] = 0;
        batch->self[lane] = self;
        batch->furthest[lane] = self == 0;
    }
}
//<

//> Compare a batch with a point
// Without a branch, for whichever lanes it is further.
INLINED void compare_far(const enum geometry geometry,
                         const uint32_t lanes,
                         const struct far_scene *scene, uint32_t s,
                         struct far_batch *batch)
{
    const struct sorted *sorted = scene->sorted;
    const double x = sorted->points.x[s], y = sorted->points.y[s];
    const int64_t i = sorted->cells.point[s];
#pragma omp simd
    for (uint32_t lane = 0; lane < lanes; lane++) {
        double far2 = pair2(geometry, scene->space, x - batch->x[lane],
                            y - batch->y[lane])
                          .far2;
        double max2 = batch->max2[lane];
        int64_t furthest = batch->furthest[lane];
        bool further =
            (i != batch->self[lane]) &
            ((far2 > max2) | ((far2 == max2) & (i < furthest)));
        batch->max2[lane] = further ? far2 : max2;
        batch->furthest[lane] = further ? i : furthest;
    }
}
//<

//> Ask whether a batch can improve
// By a point no further than the bounds, with the index i or more.
struct far_bounds {
    const double *across2, *up2; // squared separations, for each lane
};

INLINED bool can_improve(const uint32_t lanes,
                         const struct far_bounds *bounds, int64_t i,
                         const struct far_batch *batch)
{
    uint32_t some = 0;
#pragma omp simd reduction(| : some)
    for (uint32_t lane = 0; lane < lanes; lane++) {
        double bound2 = bounds->across2[lane] + bounds->up2[lane];
        double max2 = batch->max2[lane];
        some |= (max2 < bound2) |
                ((max2 == bound2) & (i < batch->furthest[lane]));
    }
    return some;
}
//<

//> Compare a batch with a cell
// No point in it is further than the bounds. Once every lane has one as
// far as that, the rest of the cell need not be compared: the indices
// are higher. Eight lanes ask after every eighth point.
INLINED void compare_cell(const enum geometry geometry,
                          const uint32_t lanes,
                          const struct far_scene *scene, uint32_t cell,
                          const struct far_bounds *bounds,
                          struct far_batch *batch)
{
    const uint32_t *point = scene->sorted->cells.point;
    const uint32_t begin = scene->sorted->cells.start[cell];
    const uint32_t end = scene->sorted->cells.start[cell + 1];
    uint32_t s = begin;
    while (s < end && can_improve(lanes, bounds, point[s], batch)) {
        uint32_t stop = end - s < lanes ? end : s + lanes;
        for (; s < stop; s++)
            compare_far(geometry, lanes, scene, s, batch);
    }
    batch->counts->cells += lanes;
    batch->counts->distances += (uint64_t)lanes * (s - begin);
}
//<
//<

//> Declare who looks far
// Those who look for their furthest points, in cells that others choose
// for them: eight together, each in a lane, or one alone. How many
// is a constant in each copy of a function.
#pragma once
#include "ch02-all-pairs/pair.h"
#include "ch04-cell-sort/block.h"
#include "ch04-cell-sort/sorted.h"
#include "common/count.h"

//> Hold those who look far
enum { ABREAST = 8 };

struct viewers {
    double x[ABREAST], y[ABREAST], most2[ABREAST];
    int64_t self[ABREAST], furthest[ABREAST]; // as wide as the rest
};

// The sorted points from s on. As long as nobody is further than 0, the
// first of the others is.
INLINED void set_viewers(const uint32_t lanes,
                         const struct sorted *sorted, uint32_t s,
                         struct viewers *viewers)
{
#pragma omp simd
    for (uint32_t lane = 0; lane < lanes; lane++) {
        int64_t self = sorted->cells.point[s + lane];
        viewers->x[lane] = sorted->points.x[s + lane];
        viewers->y[lane] = sorted->points.y[s + lane];
        viewers->most2[lane] = 0;
        viewers->self[lane] = self;
        viewers->furthest[lane] = self == 0;
    }
}
//<

//> Show a point to all who look
// Without a branch, whoever it is further for.
INLINED void show(const enum geometry geometry, const uint32_t lanes,
                  struct space space, const struct sorted *sorted,
                  uint32_t s, struct viewers *viewers)
{
    const double x = sorted->points.x[s], y = sorted->points.y[s];
    const int64_t i = sorted->cells.point[s];
#pragma omp simd
    for (uint32_t lane = 0; lane < lanes; lane++) {
        double far2 = pair2(geometry, space, x - viewers->x[lane],
                            y - viewers->y[lane])
                          .far2;
        double most2 = viewers->most2[lane];
        int64_t furthest = viewers->furthest[lane];
        bool further =
            (i != viewers->self[lane]) &
            ((far2 > most2) | ((far2 == most2) & (i < furthest)));
        viewers->most2[lane] = further ? far2 : most2;
        viewers->furthest[lane] = further ? i : furthest;
    }
}
//<

//> Ask whether anybody has hope
// Of a point no further than across2 + up2, with the index i or more.
INLINED bool some_hope(const uint32_t lanes, const double *across2,
                       const double *up2, int64_t i,
                       const struct viewers *viewers)
{
    uint32_t some = 0;
#pragma omp simd reduction(| : some)
    for (uint32_t lane = 0; lane < lanes; lane++) {
        double bound2 = across2[lane] + up2[lane];
        double most2 = viewers->most2[lane];
        some |= (most2 < bound2) |
                ((most2 == bound2) & (i < viewers->furthest[lane]));
    }
    return some;
}
//<

//> Look far in a cell
// Nobody in it is further than across2 + up2. Once everybody knows
// somebody as far as that, the rest of the cell need not be shown:
// their indices are higher. Eight ask after every eighth point.
INLINED void look_at(const enum geometry geometry, const uint32_t lanes,
                     struct space space, const struct sorted *sorted,
                     uint32_t cell, const double *across2,
                     const double *up2, struct viewers *viewers)
{
    const uint32_t *point = sorted->cells.point;
    const uint32_t begin = sorted->cells.start[cell];
    const uint32_t end = sorted->cells.start[cell + 1];
    uint32_t s = begin;
    while (s < end &&
           some_hope(lanes, across2, up2, point[s], viewers)) {
        uint32_t stop = end - s < lanes ? end : s + lanes;
        for (; s < stop; s++)
            show(geometry, lanes, space, sorted, s, viewers);
    }
    COUNT(cells, lanes);
    COUNT(distances, (uint64_t)lanes * (s - begin));
}
//<
//<

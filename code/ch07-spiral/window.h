//> Look through a window
// Cells as seen from one of them, the home: so many steps to one side,
// so many to the other. A window is a rectangle of cells around home;
// its layer k holds those whose longer way from home is k steps. A step
// beyond the last cell leads back to the first, so with wraparound the
// widest window goes half way round on either side, and shows every
// cell once.
#pragma once
#include "ch02-all-pairs/pair.h"
#include "ch04-cell-sort/block.h"

struct view {
    int32_t back, on; // steps one may take along an axis
};

struct window {
    struct view x, y;
};

//> Step along an axis
static inline uint32_t step(const struct axis *axis, uint32_t cell,
                            int32_t steps)
{
    int32_t m = axis->count, to = (int32_t)cell + steps;
    return to < 0 ? to + m : to < m ? to : to - m;
}
//<

//> See the whole axis
static inline struct view view_all(const struct axis *axis,
                                   uint32_t cell)
{
    int32_t m = axis->count, k = cell;
    if (axis->period == INFINITY)
        return (struct view){k, m - 1 - k};
    return (struct view){(m - 1) / 2, m / 2};
}
//<

static inline int32_t fewer(int32_t a, int32_t b)
{
    return a < b ? a : b;
}

static inline int32_t more(int32_t a, int32_t b)
{
    return a > b ? a : b;
}

//> Find how near the cells to one side can be
// No point in the cells from `begin` steps away, out to the end of the
// view, is nearer to x along this axis. With wraparound they can lie
// on both sides of x, and each be reached in two ways.
INLINED double margin_on(const enum geometry geometry,
                         const struct axis *axis, struct view all,
                         uint32_t cell, int32_t begin, double x)
{
    int32_t m = axis->count, from = cell + begin;
    int32_t end = (int32_t)cell + all.on + 1;
    if (geometry == STANDARD)
        return axis->border[from] - x;
    struct reach lacking = {
        .above = stretch_of(axis, from, fewer(end, m)),
        .below = stretch_of(axis, more(from, m) - m, end - m)};
    return reach_margin(axis, &lacking, x);
}

INLINED double margin_back(const enum geometry geometry,
                           const struct axis *axis, struct view all,
                           uint32_t cell, int32_t begin, double x)
{
    int32_t m = axis->count, end = (int32_t)cell - begin + 1;
    int32_t from = (int32_t)cell - all.back;
    if (geometry == STANDARD)
        return x - axis->border[end];
    struct reach lacking = {
        .below = stretch_of(axis, more(from, 0), end),
        .above = stretch_of(axis, from + m, fewer(end, 0) + m)};
    return reach_margin(axis, &lacking, x);
}
//<

//> Look no further than the square
// Only so far as a point can lie at best2 or nearer. Where it cannot,
// neither can it further out.
INLINED struct view view_square(const enum geometry geometry,
                                const struct axis *axis,
                                struct view all, uint32_t cell,
                                double x, double best2)
{
    struct view view = {0, 0};
    for (; view.back < all.back; view.back++) {
        double margin =
            margin_back(geometry, axis, all, cell, view.back + 1, x);
        if (margin * margin > best2)
            break;
    }
    for (; view.on < all.on; view.on++) {
        double margin =
            margin_on(geometry, axis, all, cell, view.on + 1, x);
        if (margin * margin > best2)
            break;
    }
    return view;
}
//<
//<

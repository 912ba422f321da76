//> Bound a search along both axes
// Cells as seen from one of them, the cell of the query: some columns
// or rows back, some ahead. Two such ranges make a box of cells, and
// layer k of it holds those whose longer way from the middle is k
// steps. A step beyond the last cell leads to the first; so with
// wraparound the widest range goes half way round to either side, and
// has every cell once. See margin_ahead for what bounds a range.
#pragma once
#include "ch04-cell-sort/block.h"
#include "common/inlined.h"
#include "common/min_max.h"

//> Declare the range and the box of a search
// Steps that a search may take from its cell along one axis: -back to
// ahead.
struct search_range {
    int32_t back, ahead;
};

struct search_box {
    struct search_range x, y; // columns, rows
};
//<

//> Step along an axis
static inline uint32_t step(const struct axis *axis, uint32_t cell,
                            int32_t steps)
{
    int32_t m = axis->count, to = (int32_t)cell + steps;
    return to < 0 ? to + m : to < m ? to : to - m;
}
//<

//> Take every cell of the axis once
static inline struct search_range whole_range(const struct axis *axis,
                                              uint32_t cell)
{
    int32_t m = axis->count, k = cell;
    if (axis->period == INFINITY)
        return (struct search_range){k, m - 1 - k};
    return (struct search_range){(m - 1) / 2, m / 2};
}
//<

//> Bound the separation of the cells ahead
// The margin: no point `steps` cells ahead, or further within the whole
// range, is nearer to x along this axis.
INLINED double margin_ahead(const enum geometry geometry,
                            const struct axis *axis,
                            struct search_range whole, uint32_t cell,
                            int32_t steps, double x)
{
    int32_t m = axis->count, first = (int32_t)cell + steps;
    int32_t end = (int32_t)cell + whole.ahead + 1;
    if (geometry == STANDARD)
        return axis->border[first] - x;
    struct axis_range outside = {
        .above = interval_of(axis, first, MIN(end, m)),
        .below = interval_of(axis, MAX(first, m) - m, end - m)};
    return range_margin(axis, &outside, x);
}
//<

//> Bound the separation of the cells back
INLINED double margin_back(const enum geometry geometry,
                           const struct axis *axis,
                           struct search_range whole, uint32_t cell,
                           int32_t steps, double x)
{
    int32_t m = axis->count, end = (int32_t)cell - steps + 1;
    int32_t first = (int32_t)cell - whole.back;
    if (geometry == STANDARD)
        return x - axis->border[end];
    struct axis_range outside = {
        .below = interval_of(axis, MAX(first, 0), end),
        .above = interval_of(axis, first + m, MIN(end, 0) + m)};
    return range_margin(axis, &outside, x);
}
//<

//> Cut the range to the square
// As far as a point can be at best2 or nearer. Where none can, none can
// be further out, since margins do not shrink.
INLINED struct search_range square_range(const enum geometry geometry,
                                         const struct axis *axis,
                                         struct search_range whole,
                                         uint32_t cell, double x,
                                         double best2)
{
    struct search_range range = {0, 0};
    for (; range.back < whole.back; range.back++) {
        double margin =
            margin_back(geometry, axis, whole, cell, range.back + 1, x);
        if (margin * margin > best2)
            break;
    }
    for (; range.ahead < whole.ahead; range.ahead++) {
        double margin = margin_ahead(geometry, axis, whole, cell,
                                     range.ahead + 1, x);
        if (margin * margin > best2)
            break;
    }
    return range;
}
//<
//<

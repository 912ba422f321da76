//> Search the rows of a piece
// What of a piece a query has to look at: of each row of its grid that
// can hold something better, the cells that can. Copies of it for each
// geometry, for near and far.
#pragma once
#include "ch11-crowds/bounds.h"
#include "ch11-crowds/tree_query.h"

//> Compare, near or far
INLINED void compare_points(const bool furthest,
                            struct tree_query *query, uint32_t begin,
                            uint32_t end)
{
    if (furthest)
        compare_furthest(query, begin, end);
    else
        compare_nearest(query, begin, end);
}
//<

//> Decide whether something can be better
// An equal distance can, if there is a lower index.
static inline bool can_be_better(const struct query *query,
                                 double bound, uint32_t lowest)
{
    return bound < query->best2 ||
           (bound == query->best2 && lowest < query->nearest);
}
//<

//> Find how far to look along one axis
// If nothing is nearer than this on the other axis. A little more than
// that, for rounding: what is found there is compared exactly. Beyond
// the period lies the same again, and the furthest image is furthest
// for what is near, so reach is what a separation must not exceed; for
// the furthest without wraparound all must be looked at.
INLINED double reach(const enum geometry geometry, const bool furthest,
                     double period, double best, double other)
{
    static const double LITTLE = 0x1p-40, LEAST = 0x1p-500;
    if (isinf(best))
        return INFINITY;
    if (!furthest) {
        const double rest2 = best * (1 + LITTLE) - other * other;
        return sqrt(MAX(0, rest2)) * (1 + LITTLE) + LEAST;
    }
    const double rest2 = -best * (1 - LITTLE) - other * other;
    if (geometry == STANDARD || !(rest2 > 0))
        return INFINITY;
    return period - sqrt(rest2) * (1 - LITTLE) + period * LITTLE;
}
//<

//> Find the cells within reach
// Of x, or of an image of x, which may be anywhere; clipped to the
// axis. Says whether there are any.
struct cell_range {
    uint32_t first, last;
};

static inline uint32_t cell_near(const struct axis *axis, double x)
{
    const double at = (x - axis->low) * axis->scale;
    if (!(at > 0))
        return 0;
    return at < axis->count ? (uint32_t)(int32_t)at : axis->count - 1;
}

static inline bool cells_within(const struct axis *axis, double x,
                                double reach, struct cell_range *range)
{
    const double low = x - reach, high = x + reach;
    if (high < axis->border[0] || low > axis->border[axis->count])
        return false;
    range->first = cell_near(axis, low);
    range->last = cell_near(axis, high);
    return true;
}
//<

//> Compare with a row of a piece
// With wraparound with the images of the query, too. Rounding moves an
// image by less than the slack.
INLINED double slack(const enum geometry geometry, double x,
                     double period)
{
    return geometry == WRAPAROUND ? (fabs(x) + period) * 0x1p-50 : 0;
}

INLINED void compare_row_of(const enum geometry geometry,
                            const bool furthest,
                            const struct piece *piece, uint32_t row,
                            struct tree_query *query)
{
    const struct space space = query->all->space;
    const struct grid *grid = &piece->sorted.grid;
    const struct axis *up = &grid->y;
    const double x = query->query.x, y = query->query.y;
    const double low = up->border[row], high = up->border[row + 1];
    const double other =
        furthest ? max_separation(geometry, space.height, low, high, y)
                 : min_separation(geometry, space.height, low, high, y);
    const double across = reach(geometry, furthest, space.width,
                                query->query.best2, other) +
                          slack(geometry, x, space.width);
    const uint32_t *start =
        piece->sorted.cells.start + (size_t)row * grid->x.count;
    const int images = geometry == WRAPAROUND;
    for (int k = -images; k <= images; k++) {
        struct cell_range range;
        if (cells_within(&grid->x, k == 0 ? x : x + k * space.width,
                         across, &range))
            compare_points(furthest, query,
                           piece->begin + start[range.first],
                           piece->begin + start[range.last + 1]);
    }
}
//<

//> Search a piece
INLINED void search_rows(const enum geometry geometry,
                         const bool furthest, const struct piece *piece,
                         struct box box, struct tree_query *query)
{
    const struct space space = query->all->space;
    const struct axis *up = &piece->sorted.grid.y;
    const double x = query->query.x, y = query->query.y;
    const double other = furthest
                             ? max_separation(geometry, space.width,
                                              box.left, box.right, x)
                             : min_separation(geometry, space.width,
                                              box.left, box.right, x);
    const double above = reach(geometry, furthest, space.height,
                               query->query.best2, other) +
                         slack(geometry, y, space.height);
    const int images = geometry == WRAPAROUND;
    for (int k = -images; k <= images; k++) {
        struct cell_range rows;
        if (!cells_within(up, k == 0 ? y : y + k * space.height, above,
                          &rows))
            continue;
        for (uint32_t row = rows.first;
             row <= rows.last && query->steps <= query->max_steps;
             row++) {
            query->steps++;
            box.bottom = up->border[row];
            box.top = up->border[row + 1];
            if (can_be_better(
                    &query->query,
                    box_bound(geometry, furthest, space, &box, x, y),
                    0))
                compare_row_of(geometry, furthest, piece, row, query);
        }
    }
}
//<
//<

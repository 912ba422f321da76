//> Query all pieces
// A stack of boxes that may hold something better. In a piece, the rows
// of its grid that can, and of each row a span.
#include "ch11-crowds/piece_query.h"
#include "ch09-row-spans/span_kernels.h"
#include "ch11-crowds/bounds.h"
#include <assert.h>

//> Compare with a stretch of points
void compare_nearest(struct piece_query *query, uint32_t begin,
                     uint32_t end)
{
    query->all->kernels->compare(query->all, begin, end, &query->query);
    query->query.compared += end - begin;
    query->steps += end - begin;
}

void compare_furthest(struct piece_query *query, uint32_t begin,
                      uint32_t end)
{
    const struct points p = query->pieces->sorted.points;
    const uint32_t *point = query->pieces->sorted.cells.point;
    struct point_query *q = &query->query;
    for (uint32_t s = begin; s < end; s++) {
        const double far2 =
            furthest2(query->all->space, p.x[s] - q->x, p.y[s] - q->y);
        if (point[s] != q->self)
            query_keep(q, -far2, point[s]);
    }
    q->compared += end - begin;
    query->steps += end - begin;
}

INLINED void compare(const bool furthest, struct piece_query *query,
                     uint32_t begin, uint32_t end)
{
    if (furthest)
        compare_furthest(query, begin, end);
    else
        compare_nearest(query, begin, end);
}
//<

//> Decide whether something can be better
// An equal distance can, if there is a lower index.
static inline bool can_be_better(const struct point_query *query,
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
                            struct piece_query *query)
{
    const struct space space = query->all->space;
    const struct grid *grid = &piece->sorted.grid;
    const struct axis *up = &grid->y;
    const double x = query->query.x, y = query->query.y;
    const double low = up->border[row], high = up->border[row + 1];
    const double other =
        furthest
            ? most_separation(geometry, space.height, low, high, y)
            : least_separation(geometry, space.height, low, high, y);
    const double across =
        reach(geometry, furthest, space.width,
              query->query.best2, other) +
        slack(geometry, x, space.width);
    const uint32_t *start =
        piece->sorted.cells.start + (size_t)row * grid->x.count;
    const int images = geometry == WRAPAROUND;
    for (int k = -images; k <= images; k++) {
        struct cell_range range;
        if (cells_within(&grid->x, k == 0 ? x : x + k * space.width,
                         across, &range))
            compare(furthest, query, piece->begin + start[range.first],
                    piece->begin + start[range.last + 1]);
    }
    query->steps++;
}
//<

//> Search a piece
INLINED void search_rows(const enum geometry geometry,
                         const bool furthest, const struct piece *piece,
                         struct box box, struct piece_query *query)
{
    const struct space space = query->all->space;
    const struct axis *up = &piece->sorted.grid.y;
    const double x = query->query.x, y = query->query.y;
    const double other =
        furthest ? most_separation(geometry, space.width, box.left,
                                   box.right, x)
                 : least_separation(geometry, space.width, box.left,
                                    box.right, x);
    const double above =
        reach(geometry, furthest, space.height, query->query.best2,
              other) +
        slack(geometry, y, space.height);
    const int images = geometry == WRAPAROUND;
    for (int k = -images; k <= images; k++) {
        struct cell_range rows;
        if (!cells_within(up, k == 0 ? y : y + k * space.height, above,
                          &rows))
            continue;
        for (uint32_t row = rows.first; row <= rows.last; row++) {
            box.bottom = up->border[row];
            box.top = up->border[row + 1];
            if (query->steps <= query->most &&
                can_be_better(&query->query,
                              box_bound(geometry, furthest, space, &box,
                                        x, y),
                              0))
                compare_row_of(geometry, furthest, piece, row, query);
        }
    }
}
//<

//> Search what is in one place
// All at one distance: the lowest index will do. But if they are only
// nearly in one place, and far away, they are compared.
INLINED void search_place(const enum geometry geometry,
                          const bool furthest,
                          const struct piece *piece,
                          const struct node *node,
                          struct piece_query *query)
{
    struct point_query *q = &query->query;
    const uint32_t n = piece->sorted.points.n;
    const uint32_t index =
        piece->lowest != q->self ? piece->lowest : piece->second;
    if (index == NO_INDEX)
        return;
    if (!box_is_place(&node->box)) {
        compare(furthest, query, piece->begin, piece->begin + n);
        return;
    }
    query_keep(q,
               box_bound(geometry, furthest, query->all->space,
                         &node->box, q->x, q->y),
               index);
    q->compared++;
    query->steps++;
}
//<

//> Search down the tree of boxes
struct waiting {
    double bound;
    uint32_t node;
};

// Of a list, an eighth is cut off at least, or all but what is equal.
enum { DEEPEST = 512 };

INLINED bool query_pieces(const enum geometry geometry,
                          const bool furthest,
                          struct piece_query *query)
{
    const struct pieces *pieces = query->pieces;
    const struct point_query *q = &query->query;
    struct waiting stack[DEEPEST];
    int height = 1;
    stack[0] = (struct waiting){-INFINITY, 0};
    while (height > 0 && query->steps <= query->most) {
        const struct waiting next = stack[--height];
        const struct node *node = &pieces->node[next.node];
        if (!can_be_better(q, next.bound, node->lowest))
            continue;
        query->steps++;
        if (node->child == 0) {
            const struct piece *piece = &pieces->piece[node->piece];
            if (piece->is_place)
                search_place(geometry, furthest, piece, node, query);
            else
                search_rows(geometry, furthest, piece, node->box,
                            query);
            continue;
        }
        //> Put both children on the stack, the better one last
        struct waiting a = {0, node->child}, b = {0, node->sibling};
        a.bound =
            box_bound(geometry, furthest, query->all->space,
                      &pieces->node[a.node].box, q->x, q->y);
        b.bound =
            box_bound(geometry, furthest, query->all->space,
                      &pieces->node[b.node].box, q->x, q->y);
        const bool swap = a.bound < b.bound;
        assert(height + 2 <= DEEPEST && "cuts are medians");
        stack[height++] = swap ? b : a;
        stack[height++] = swap ? a : b;
        //<
    }
    return query->steps <= query->most;
}

bool query_nearest(struct piece_query *query)
{
    return query->all->space.geometry == STANDARD
               ? query_pieces(STANDARD, false, query)
               : query_pieces(WRAPAROUND, false, query);
}

bool query_furthest(struct piece_query *query)
{
    return query->all->space.geometry == STANDARD
               ? query_pieces(STANDARD, true, query)
               : query_pieces(WRAPAROUND, true, query);
}
//<
//<

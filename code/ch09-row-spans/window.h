//> Stage once for many tiles
// The tiles of a row share nearly all of their blocks. So a window of
// them is staged at once, three rows side by side, and the sweep of
// each tile finds its three spans there. What the sweep meets beyond
// the end of a span is a candidate like any other, or nobody at all, so
// that spans may be swept in steps. An instruction set brings three
// more functions: frame stages a row, sweep goes over three spans, and
// reply answers the eight of a tile.
#pragma once
#include "ch09-row-spans/tile.h"

// In a frame, candidates stand between FAR on both sides. Who stands at
// place k of frame r has the number k + r * FRAME. In a window as wide
// as this, few rows of points spread evenly have more than fit.
enum {
    WINDOW = 40, // who ask, at most
    FRAME = 80,
    MOST_FRAMED = FRAME - 2 * SPILLED,
    EACH = 4, // a sweep's step
    ROWS = 3
};

//> Find a span
// Of the row before this one, if it exists; else it is empty.
struct span {
    uint32_t begin, end;
};

INLINED struct span span_of(const struct sorted *sorted, uint32_t next,
                            uint32_t first, uint32_t last)
{
    const uint32_t columns = sorted->grid.x.count;
    if (next == 0 || next > sorted->grid.y.count)
        return (struct span){0, 0};
    const uint32_t *start = sorted->cells.start + (next - 1) * columns;
    return (struct span){start[first], start[last + 1]};
}
//<

//> Hold a window
struct frame {
    uint32_t begin; // of the sorted points, the one at x[SPILLED]
    float x[FRAME + SPILLED], y[FRAME + SPILLED];
};

struct window {
    uint32_t begin, width, row; // who ask: points, a row of the grid
    struct frame frame[ROWS];   // below, their own, above
    double x, y, reach;         // as a tile's
    uint32_t number[ROWS * FRAME + SPILLED]; // number[k] is k
};
//<

//> Point out three spans
// Of frame r, the places begin[r] to end[r], in steps; in the middle
// one, those who ask stand from own on.
struct glance {
    uint32_t begin[ROWS], end[ROWS], own;
};
//<

// Writes the points as seen from (x, y), and FAR around them.
typedef void frame_function(const struct sorted *sorted,
                            struct span span, double x, double y,
                            struct frame *frame);

// Finds the two smallest for every one of those who ask.
typedef void glance_function(const struct window *window,
                             const struct glance *glance,
                             struct sieve *sieve);

//> Reply to all who ask
struct reply {
    double near2[ASKING];
    uint32_t who[ASKING];
    float slack;
};

// Computes the distances of those whom the sieve names, and returns a
// bit for each who asks: whether he is sure. Reads coordinates of eight
// points from the tile's first on.
typedef uint32_t reply_function(const enum geometry geometry,
                                struct space space,
                                const struct sorted *sorted,
                                const struct tile *tile,
                                const struct window *window,
                                const struct sieve *sieve,
                                struct reply *reply);
//<

//> Open a window
// False if a table would not do either, or too many are in a row, or
// the window is near the seam.
INLINED bool open_window(const enum geometry geometry,
                         frame_function *frame,
                         const struct sorted *sorted,
                         struct window *window)
{
    const struct axis *x = &sorted->grid.x, *y = &sorted->grid.y;
    const double *across = sorted->points.x + window->begin;
    const uint32_t row = window->row;
    uint32_t from = axis_cell(x, across[0]);
    uint32_t to = axis_cell(x, across[window->width - 1]);
    if (geometry == WRAPAROUND &&
        (from == 0 || row == 0 || to + 1 == x->count ||
         row + 1 == y->count || to - from + 3 == x->count ||
         y->count == ROWS))
        return false;
    uint32_t first = from > 0 ? from - 1 : 0;
    uint32_t last = to + 1 < x->count ? to + 1 : to;
    uint32_t low = row > 0 ? row - 1 : 0;
    uint32_t high = row + 1 < y->count ? row + 1 : row;
    window->x = x->border[first] / 2 + x->border[last + 1] / 2;
    window->y = y->border[low] / 2 + y->border[high + 1] / 2;
    window->reach = most(most(window->x - x->border[first],
                              x->border[last + 1] - window->x),
                         most(window->y - y->border[low],
                              y->border[high + 1] - window->y));
    if (!(window->reach > LEAST_REACH && window->reach < MOST_REACH))
        return false;
    for (uint32_t k = 0; k < ROWS; k++) {
        struct span span = span_of(sorted, row + k, first, last);
        if (span.end - span.begin > MOST_FRAMED)
            return false;
        frame(sorted, span, window->x, window->y, &window->frame[k]);
    }
    return true;
}
//<

//> Point to the spans of a tile
INLINED void point_out(const struct sorted *sorted,
                       const struct window *window,
                       const struct tile *tile, struct glance *glance)
{
    const struct reach *x = &tile->block.x;
    uint32_t shown = 0;
    for (uint32_t k = 0; k < ROWS; k++) {
        struct span span = span_of(sorted, tile->row + k, x->first,
                                   x->first + x->count - 1);
        uint32_t shift = SPILLED - window->frame[k].begin;
        glance->begin[k] = span.begin + shift;
        glance->end[k] = span.end + shift;
        shown += span.end - span.begin;
    }
    glance->own = tile->begin + SPILLED - window->frame[1].begin;
    COUNT(distances, (uint64_t)(shown - tile->width + ASKING) * ASKING);
    (void)shown;
}
//<

//> Ask through a window
// Those who are not sure ask alone.
INLINED void ask_window(const enum geometry geometry,
                        glance_function *sweep, reply_function *reply,
                        meet_function *meet, struct space space,
                        const struct sorted *sorted,
                        const struct window *window,
                        const struct tile *tile, struct answers *found)
{
    const uint32_t k = tile->begin - tile->first;
    const float slack = (float)(tile->reach * tile->reach) * 0x1p-27f;
    struct glance glance;
    struct sieve sieve;
    struct reply here;
    here.slack = slack;
    point_out(sorted, window, tile, &glance);
    sweep(window, &glance, &sieve);
    uint32_t sure =
        reply(geometry, space, sorted, tile, window, &sieve, &here);
    const uint32_t width = tile->width;
    if (width == ASKING) {
        memcpy(found->nearest2 + k, here.near2, sizeof here.near2);
        memcpy(found->nearest + k, here.who, sizeof here.who);
        if (sure == (1 << ASKING) - 1)
            return;
    }
    memcpy(found->nearest2 + k, here.near2, width * sizeof(double));
    memcpy(found->nearest + k, here.who, width * sizeof(uint32_t));
    for (uint32_t lane = 0; lane < tile->width; lane++)
        if (!(sure >> lane & 1)) {
            struct single single =
                ask_alone(geometry, meet, true, space, sorted,
                          tile->begin + lane);
            put(found, k + lane, single.nearest, single.best2);
        }
}
//<

//> Go from tile to tile of a window
// If it is not open, each takes a table.
INLINED void go_through(const enum geometry geometry,
                        stage_function *stage, sift_function *sift,
                        glance_function *sweep, reply_function *reply,
                        meet_function *meet, struct space space,
                        const struct sorted *sorted,
                        const struct window *window, bool open,
                        uint32_t first, struct answers *found)
{
    const struct grid *grid = &sorted->grid;
    const uint32_t end = window->begin + window->width;
    struct tile tile = {.begin = window->begin,
                        .row = window->row,
                        .first = first,
                        .reach = window->reach};
    tile.block.y = axis_reach(&grid->y, tile.row, tile.row, 1);
    for (; tile.begin < end; tile.begin += ASKING) {
        const double *x = sorted->points.x + tile.begin;
        uint32_t left = end - tile.begin;
        tile.width = left < ASKING ? left : ASKING;
        tile.block.x =
            axis_reach(&grid->x, axis_cell(&grid->x, x[0]),
                       axis_cell(&grid->x, x[tile.width - 1]), 1);
        if (open && sorted->points.n - tile.begin >= ASKING) {
            ask_window(geometry, sweep, reply, meet, space, sorted,
                       window, &tile, found);
        } else {
            struct tile alone = tile;
            ask_together(geometry, stage, sift, meet, space, sorted,
                         &alone, found);
        }
    }
}
//<

//> Go from window to window
// A window ends where its row ends.
INLINED void go_by_windows(const enum geometry geometry,
                           stage_function *stage, sift_function *sift,
                           frame_function *frame,
                           glance_function *sweep,
                           reply_function *reply, meet_function *meet,
                           struct space space,
                           const struct sorted *sorted, uint32_t begin,
                           uint32_t end, struct answers *found)
{
    const struct axis *up = &sorted->grid.y;
    const uint32_t columns = sorted->grid.x.count;
    struct window window;
    window.begin = begin;
    window.row = axis_cell(up, sorted->points.y[begin]);
    for (uint32_t k = 0; k < ROWS * FRAME + SPILLED; k++)
        window.number[k] = k;
    for (; window.begin < end; window.begin += window.width) {
        uint32_t stop;
        while (
            (stop = sorted->cells.start[(window.row + 1) * columns]) <=
            window.begin)
            window.row++;
        window.width = (stop < end ? stop : end) - window.begin;
        window.width = window.width < WINDOW ? window.width : WINDOW;
        bool open = open_window(geometry, frame, sorted, &window);
        go_through(geometry, stage, sift, sweep, reply, meet, space,
                   sorted, &window, open, begin, found);
    }
}
//<
//<

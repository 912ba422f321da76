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

//> Reply to all who ask
struct reply {
    double d2[ASKING];
    uint32_t who[ASKING];
};

// Finds the candidates of a tile that are best for those who ask, and
// returns a bit for each: whether he is sure. Reads coordinates of
// eight points from the tile's first on.
typedef uint32_t glance_function(const enum geometry geometry,
                                 struct space space,
                                 const struct sorted *sorted,
                                 const struct window *window,
                                 const struct tile *tile,
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
INLINED struct glance point_out(const struct sorted *sorted,
                                const struct window *window,
                                const struct tile *tile)
{
    const struct reach *x = &tile->block.x;
    struct glance glance;
    uint32_t shown = 0;
    for (uint32_t k = 0; k < ROWS; k++) {
        struct span span = span_of(sorted, tile->row + k, x->first,
                                   x->first + x->count - 1);
        uint32_t shift = SPILLED - window->frame[k].begin;
        glance.begin[k] = span.begin + shift;
        glance.end[k] = span.end + shift;
        shown += span.end - span.begin;
    }
    glance.own = tile->begin + SPILLED - window->frame[1].begin;
    COUNT(distances, (uint64_t)(shown - tile->width + ASKING) * ASKING);
    (void)shown;
    return glance;
}
//<

//> Ask through a window
// Those who are not sure ask alone.
INLINED void ask_window(const enum geometry geometry,
                        glance_function *glance, meet_function *meet,
                        struct space space, const struct sorted *sorted,
                        const struct window *window,
                        const struct tile *tile, struct answers *found)
{
    const uint32_t k = tile->begin - tile->first, width = tile->width;
    struct reply reply;
    uint32_t sure =
        glance(geometry, space, sorted, window, tile, &reply);
    if (width == ASKING) {
        memcpy(found->nearest2 + k, reply.d2, sizeof reply.d2);
        memcpy(found->nearest + k, reply.who, sizeof reply.who);
        if (sure == (1 << ASKING) - 1)
            return;
    }
    memcpy(found->nearest2 + k, reply.d2, width * sizeof(double));
    memcpy(found->nearest + k, reply.who, width * sizeof(uint32_t));
    for (uint32_t lane = 0; lane < width; lane++)
        if (!(sure >> lane & 1)) {
            struct single single =
                ask_alone(geometry, meet, true, space, sorted,
                          tile->begin + lane);
            put(found, k + lane, single.nearest, single.best2);
        }
}
//<

//> Go from tile to tile of a window
// Begins before the first; false when there are no more.
INLINED bool next_tile(const struct sorted *sorted,
                       const struct window *window, struct tile *tile)
{
    const struct axis *across = &sorted->grid.x;
    tile->begin += tile->width;
    const uint32_t left = window->begin + window->width - tile->begin;
    if (left == 0)
        return false;
    const double *x = sorted->points.x + tile->begin;
    tile->width = left < ASKING ? left : ASKING;
    tile->block.x =
        axis_reach(across, axis_cell(across, x[0]),
                   axis_cell(across, x[tile->width - 1]), 1);
    return true;
}

INLINED struct tile before_tiles(const struct sorted *sorted,
                                 const struct window *window,
                                 uint32_t first)
{
    struct tile tile = {.begin = window->begin,
                        .row = window->row,
                        .first = first,
                        .reach = window->reach};
    tile.block.y = axis_reach(&sorted->grid.y, tile.row, tile.row, 1);
    return tile;
}

// Whether there are eight to be read.
INLINED bool tile_is_whole(const struct sorted *sorted,
                           const struct tile *tile)
{
    return sorted->points.n - tile->begin >= ASKING;
}
//<

//> Go from window to window
// A window ends where its row ends. With wraparound, a row begins and
// ends with a short one: so little is near the seam.
INLINED uint32_t window_width(const enum geometry geometry,
                              uint32_t before, uint32_t left)
{
    if (geometry == WRAPAROUND && (before == 0 || left <= ASKING))
        return left < ASKING ? left : ASKING;
    if (geometry == WRAPAROUND && left < WINDOW + ASKING)
        return left - ASKING;
    return left < WINDOW ? left : WINDOW;
}

INLINED bool next_window(const enum geometry geometry,
                         const struct sorted *sorted, uint32_t end,
                         struct window *window)
{
    const uint32_t columns = sorted->grid.x.count;
    const uint32_t *start = sorted->cells.start;
    window->begin += window->width;
    if (window->begin == end)
        return false;
    while (start[(window->row + 1) * columns] <= window->begin)
        window->row++;
    const uint32_t *row = start + window->row * columns;
    uint32_t stop = row[columns] < end ? row[columns] : end;
    window->width = window_width(geometry, window->begin - row[0],
                                 stop - window->begin);
    return true;
}

INLINED void before_windows(const struct sorted *sorted, uint32_t begin,
                            struct window *window)
{
    window->begin = begin;
    window->width = 0;
    window->row = axis_cell(&sorted->grid.y, sorted->points.y[begin]);
    for (uint32_t k = 0; k < ROWS * FRAME + SPILLED; k++)
        window->number[k] = k;
}
//<

//> Go by windows
// Where a window is not open, each tile takes a table.
INLINED void go_by_windows(const enum geometry geometry,
                           stage_function *stage, sift_function *sift,
                           frame_function *frame,
                           glance_function *glance, meet_function *meet,
                           struct space space,
                           const struct sorted *sorted,
                           const struct visit *visit, uint32_t begin,
                           uint32_t end, struct answers *found)
{
    struct window window;
    before_windows(sorted, begin, &window);
    while (next_window(geometry, sorted, end, &window)) {
        bool open = open_window(geometry, frame, sorted, &window);
        struct tile tile = before_tiles(sorted, &window, begin);
        while (next_tile(sorted, &window, &tile)) {
            bool ready = open && tile_is_whole(sorted, &tile);
            if (ready) {
                ask_window(geometry, glance, meet, space, sorted,
                           &window, &tile, found);
            } else {
                struct tile copy = tile; // so tile stays in registers
                ask_together(geometry, stage, sift, meet, space, sorted,
                             &copy, found);
            }
            if (visit) {
                struct tile copy = tile;
                visit->tile(visit->context, ready ? &window : NULL,
                            &copy, found);
            }
        }
    }
}
//<
//<

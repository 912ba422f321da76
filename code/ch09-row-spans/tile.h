//> Ask with eight, and sift
// The search of row_spans.h, for one thread and one instruction set,
// which brings three functions: stage copies a span to the table, sift
// sweeps over the table, and meet serves those who ask alone.
#pragma once
#include "ch09-row-spans/alone.h"
#include "ch09-row-spans/manners.h"
#include <string.h>

// MOST_STAGED: as many as the low bits of a distance can number. Those
// who fill or read the table may go SPILLED entries too far.
enum { ASKING = 8, MOST_STAGED = 256, SPILLED = 8, STEPS = 4 };

// A squared distance beyond any that are sifted, whose low bits are 0,
// and a coordinate beyond that.
static const float FAR2 = 0x1p100f, FAR = 0x1p60f;

//> Hold the candidates of a tile
// Those who ask come first. Coordinates are measured from an origin
// near the tile, so that single precision is enough for them.
struct table {
    uint32_t count;
    float x[MOST_STAGED + 2 * SPILLED], y[MOST_STAGED + 2 * SPILLED];
    uint32_t place[MOST_STAGED + 2 * SPILLED]; // among the sorted
};
//<

//> Hold what the sweep finds
// For each who asks, the two smallest squared distances. The low bits
// say whose they are: the number of a candidate in the table.
struct sieve {
    float best[ASKING], second[ASKING];
};
enum { NUMBER_BITS = MOST_STAGED - 1 };

static inline uint32_t number_of(float d2)
{
    uint32_t bits;
    memcpy(&bits, &d2, sizeof bits);
    return bits & NUMBER_BITS;
}
//<

// Appends the sorted points begin .. end - 1, as seen from (x, y), to
// the table, which has room for them.
typedef void stage_function(const struct sorted *sorted, uint32_t begin,
                            uint32_t end, double x, double y,
                            struct table *table);

// Finds the two smallest for every one of the first eight in the table;
// nobody meets himself. The table goes on with FAR for SPILLED more.
typedef void sift_function(const struct table *table,
                           struct sieve *sieve);

struct tile {
    uint32_t begin, row; // of the sorted points; of the grid
    uint32_t width;      // who ask: as many from begin on
    uint32_t first;      // whose answer comes first
    struct block block;
    double x, y;  // the origin of its table
    double reach; // no candidate is further from it, on either axis
};

// So that squares are far from what floats can hold.
static const double LEAST_REACH = 0x1p-40, MOST_REACH = 0x1p+44;

//> See a part of the block
// Where the origin lies for those who are beyond the seam, if home is
// not, or the other way round.
INLINED double seen_from(const struct axis *axis,
                         const struct reach *reach, uint32_t home,
                         double origin, bool beyond)
{
    bool home_beyond = home < reach->first;
    if (beyond == home_beyond)
        return origin;
    return beyond ? origin - axis->period : origin + axis->period;
}

// That origin is rounded, as coarsely as doubles of its size are. It
// must be finer than single precision.
INLINED bool seam_is_fine(const struct axis *axis, double origin,
                          double reach)
{
    return fabs(origin) + axis->period <= reach * 0x1p22;
}
//<

//> Measure how far the block reaches
INLINED double furthest_in(const struct axis *axis,
                           const struct reach *reach, uint32_t home,
                           double origin)
{
    uint32_t end = reach->first + reach->count;
    bool beyond = end > axis->count;
    double low = seen_from(axis, reach, home, origin, false);
    double high = seen_from(axis, reach, home, origin, beyond);
    return most(low - axis->border[reach->first],
                axis->border[beyond ? end - axis->count : end] - high);
}
//<

//> Stage plainly
INLINED void stage_plainly(const struct sorted *sorted, uint32_t begin,
                           uint32_t end, double x, double y, uint32_t k,
                           struct table *table)
{
    for (uint32_t s = begin; s < end; s++, k++) {
        table->x[k] = (float)(sorted->points.x[s] - x);
        table->y[k] = (float)(sorted->points.y[s] - y);
        table->place[k] = s;
    }
}
//<

//> Stage a span
// Those who ask are in the table already.
INLINED void stage_span(stage_function *stage,
                        const struct sorted *sorted,
                        const struct tile *tile, uint32_t begin,
                        uint32_t end, double x, double y,
                        struct table *table)
{
    uint32_t asked = tile->begin + tile->width;
    if (begin <= tile->begin && asked <= end) {
        stage(sorted, begin, tile->begin, x, y, table);
        begin = asked;
    }
    stage(sorted, begin, end, x, y, table);
}
//<

//> Stage the block
// Unless it has more points than the table. Says whether it could.
INLINED bool stage_block(stage_function *stage,
                         const struct sorted *sorted,
                         const struct tile *tile, uint32_t column,
                         struct table *table)
{
    const struct axis *across = &sorted->grid.x, *up = &sorted->grid.y;
    const struct reach *x = &tile->block.x, *y = &tile->block.y;
    const uint32_t end = x->first + x->count;
    const double here = seen_from(across, x, column, tile->x, false);
    const double there = seen_from(across, x, column, tile->x, true);
    for (uint32_t k = 0; k < y->count; k++) {
        uint32_t row = reach_cell(up, y, k);
        const uint32_t *start =
            sorted->cells.start + row * across->count;
        double level =
            seen_from(up, y, tile->row, tile->y, row < y->first);
        uint32_t first = start[x->first];
        uint32_t stop =
            start[end < across->count ? end : across->count];
        uint32_t more = end > across->count
                            ? start[end - across->count] - *start
                            : 0;
        if (table->count + (stop - first) + more > MOST_STAGED)
            return false;
        stage_span(stage, sorted, tile, first, stop, here, level,
                   table);
        if (more > 0)
            stage_span(stage, sorted, tile, *start, *start + more,
                       there, level, table);
    }
    return true;
}
//<

//> Fill the table
// False if the table will not do: the block is too full, or its
// coordinates do not fit into single precision, or with wraparound it
// goes all the way round, so that a point can be near on two sides.
INLINED bool fill(const enum geometry geometry, stage_function *stage,
                  const struct sorted *sorted, struct tile *tile,
                  uint32_t from, uint32_t to, struct table *table)
{
    const struct axis *x = &sorted->grid.x, *y = &sorted->grid.y;
    const struct block *block = &tile->block;
    tile->x = x->border[from] / 2 + x->border[to + 1] / 2;
    tile->y = y->border[tile->row] / 2 + y->border[tile->row + 1] / 2;
    tile->reach = most(furthest_in(x, &block->x, from, tile->x),
                       furthest_in(y, &block->y, tile->row, tile->y));
    if (!(tile->reach > LEAST_REACH && tile->reach < MOST_REACH))
        return false;
    if (geometry == WRAPAROUND &&
        (block->x.count == x->count || block->y.count == y->count ||
         !seam_is_fine(x, tile->x, tile->reach) ||
         !seam_is_fine(y, tile->y, tile->reach)))
        return false;
    table->count = 0;
    stage(sorted, tile->begin, tile->begin + tile->width, tile->x,
          tile->y, table);
    for (uint32_t k = tile->width; k < ASKING; k++)
        table->x[k] = table->y[k] = FAR;
    table->count = ASKING;
    if (!stage_block(stage, sorted, tile, from, table))
        return false;
    for (uint32_t k = 0; k < SPILLED; k++)
        table->x[table->count + k] = table->y[table->count + k] = FAR;
    return true;
}
//<

//> Find the margins
// As block_margin has them, for all who ask.
INLINED void find_margins(const enum geometry geometry,
                          const struct sorted *sorted,
                          const struct tile *tile,
                          double margin2[ASKING])
{
    const double *x = sorted->points.x + tile->begin;
    const double *y = sorted->points.y + tile->begin;
    const struct block *block = &tile->block;
    for (uint32_t lane = 0; lane < tile->width; lane++) {
        double margin;
        if (geometry == STANDARD)
            margin = least(least(x[lane] - block->x.below.high,
                                 block->x.above.low - x[lane]),
                           least(y[lane] - block->y.below.high,
                                 block->y.above.low - y[lane]));
        else
            margin =
                block_margin(&sorted->grid, block, x[lane], y[lane]);
        margin2[lane] = margin * margin;
    }
}
//<

static inline void put(struct answers *found, uint32_t k,
                       uint32_t nearest, double nearest2)
{
    found->nearest[k] = nearest;
    found->nearest2[k] = nearest2;
}

// How far two squared distances can be off, besides 2^-12 of the less.
INLINED float near_slack(double reach)
{
    return (float)(reach * reach) * 0x1p-27f;
}

//> Answer those who are sure
// The rest ask alone.
INLINED void answer(const enum geometry geometry, meet_function *meet,
                    struct space space, const struct sorted *sorted,
                    const struct tile *tile, const struct table *table,
                    const struct sieve *sieve, struct answers *found)
{
    const double *x = sorted->points.x, *y = sorted->points.y;
    const uint32_t *point = sorted->cells.point;
    const float slack = near_slack(tile->reach);
    double margin2[ASKING];
    find_margins(geometry, sorted, tile, margin2);
    for (uint32_t lane = 0; lane < tile->width; lane++) {
        uint32_t s = tile->begin + lane;
        uint32_t t = table->place[number_of(sieve->best[lane])];
        double near2 =
            pair2(geometry, space, x[t] - x[s], y[t] - y[s]).near2;
        bool sure = sieve->second[lane] >
                    sieve->best[lane] * (1 + 0x1p-12f) + slack;
        if (sure && near2 < margin2[lane]) {
            put(found, s - tile->first, point[t], near2);
        } else {
            struct single single =
                ask_alone(geometry, meet, true, space, sorted, s);
            put(found, s - tile->first, single.nearest, single.best2);
        }
    }
}
//<

//> Ask with a tile
// A table that cannot be filled leaves nobody sure.
INLINED void ask_together(const enum geometry geometry,
                          stage_function *stage, sift_function *sift,
                          meet_function *meet, struct space space,
                          const struct sorted *sorted,
                          struct tile *tile, struct answers *found)
{
    const struct grid *grid = &sorted->grid;
    const double *x = sorted->points.x + tile->begin;
    uint32_t from = axis_cell(&grid->x, x[0]);
    uint32_t to = axis_cell(&grid->x, x[tile->width - 1]);
    struct table table;
    struct sieve sieve = {{0}, {0}};
    tile->block = block_around(grid, tile->row, from, to, 1);
    if (fill(geometry, stage, sorted, tile, from, to, &table)) {
        sift(&table, &sieve);
        COUNT(distances, (uint64_t)table.count * ASKING);
    } else {
        table.place[0] = tile->begin;
    }
    answer(geometry, meet, space, sorted, tile, &table, &sieve, found);
}
//<

//> Go along a stretch of the sorted points
// A tile ends where its row ends.
INLINED void go_along(const enum geometry geometry,
                      stage_function *stage, sift_function *sift,
                      meet_function *meet, struct space space,
                      const struct sorted *sorted,
                      const struct visit *visit, uint32_t begin,
                      uint32_t end, struct answers *found)
{
    const struct grid *grid = &sorted->grid;
    const uint32_t *start = sorted->cells.start;
    const uint32_t columns = grid->x.count;
    struct tile tile = {
        .begin = begin,
        .first = begin,
        .row = axis_cell(&grid->y, sorted->points.y[begin])};
    for (; tile.begin < end; tile.begin += tile.width) {
        while (start[(tile.row + 1) * columns] <= tile.begin)
            tile.row++;
        uint32_t stop = start[(tile.row + 1) * columns];
        tile.width = (stop < end ? stop : end) - tile.begin;
        tile.width = tile.width < ASKING ? tile.width : ASKING;
        ask_together(geometry, stage, sift, meet, space, sorted, &tile,
                     found);
        if (visit)
            visit->tile(visit->context, NULL, &tile, found);
    }
}
//<

//> Go along in one of three ways
INLINED void go(const enum geometry geometry, stage_function *stage,
                sift_function *sift, meet_function *meet,
                struct space space, const struct sorted *sorted,
                enum manner manner, const struct visit *visit,
                uint32_t begin, uint32_t end, struct answers *found)
{
    if (manner == TOGETHER)
        go_along(geometry, stage, sift, meet, space, sorted, visit,
                 begin, end, found);
    else
        for (uint32_t s = begin; s < end; s++) {
            struct single single = ask_alone(
                geometry, meet, manner == SKIPPING, space, sorted, s);
            put(found, s - begin, single.nearest, single.best2);
        }
}
//<
//<

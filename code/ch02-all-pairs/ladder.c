//> Climb from the first version to the last
// The middle steps of the ladder, each one change away from the step
// before: the distance in sight, no test for the point itself,
// distances before indices, eight candidates at once. All go through
// all pairs. The first step is first.c, the last two are tiles.c.
#include "ch02-all-pairs/ladder.h"
#include "ch02-all-pairs/first.h"
#include "ch02-all-pairs/tile.h"
#include "ch02-all-pairs/tiles.h"

//> Keep the best so far
struct found {
    double near2, far2;
    uint32_t nearest, furthest;
};

static inline void keep(struct found *found, const double result[2],
                        uint32_t j)
{
    if (result[0] < found->near2) {
        found->near2 = result[0];
        found->nearest = j;
    }
    if (result[1] > found->far2) {
        found->far2 = result[1];
        found->furthest = j;
    }
}

static inline void write_down(const struct found *found,
                              struct answers *answers, uint32_t i)
{
    answers->nearest[i] = found->nearest;
    answers->nearest2[i] = found->near2;
    answers->furthest[i] = found->furthest;
    answers->furthest2[i] = found->far2;
}
//<

//> Let the compiler see the distance
INLINED void compare(const enum geometry geometry,
                     const struct question *question, uint32_t i,
                     uint32_t j, struct found *found)
{
    const struct points p = question->points;
    double dx = p.x[j] - p.x[i], dy = p.y[j] - p.y[i], result[2];
    if (geometry == STANDARD)
        in_standard(&question->space, dx, dy, result);
    else
        in_wraparound(&question->space, dx, dy, result);
    keep(found, result, j);
}
//<

//> Search with a distance in sight
INLINED void inlined(const enum geometry geometry,
                     const struct question *question,
                     struct answers *answers, uint32_t begin,
                     uint32_t end)
{
    for (uint32_t i = begin; i < end; i++) {
        struct found found = {INFINITY, 0, i == 0, i == 0};
        for (uint32_t j = 0; j < question->points.n; j++)
            if (j != i)
                compare(geometry, question, i, j, &found);
        write_down(&found, answers, i);
    }
}

SPECIALIZE(inlined)
//<

//> Skip the point itself without a test
INLINED void split(const enum geometry geometry,
                   const struct question *question,
                   struct answers *answers, uint32_t begin,
                   uint32_t end)
{
    for (uint32_t i = begin; i < end; i++) {
        struct found found = {INFINITY, 0, i == 0, i == 0};
        //> Compare with those before and those after
        for (uint32_t j = 0; j < i; j++)
            compare(geometry, question, i, j, &found);
        for (uint32_t j = i + 1; j < question->points.n; j++)
            compare(geometry, question, i, j, &found);
        //<
        write_down(&found, answers, i);
    }
}

SPECIALIZE(split)
//<

//> Keep distances only
INLINED void sweep(const enum geometry geometry,
                   const struct question *question, uint32_t i,
                   uint64_t begin, uint64_t end,
                   struct pair_distances *best)
{
    const struct points p = question->points;
    for (uint64_t j = begin; j < end; j++) {
        struct pair_distances pair =
            pair2(geometry, question->space, p.x[j] - p.x[i],
                  p.y[j] - p.y[i]);
        best->near2 = MIN(pair.near2, best->near2);
        best->far2 = MAX(pair.far2, best->far2);
    }
}
//<

//> Note the block, find the index later
INLINED void blocks(const enum geometry geometry,
                    const struct question *question,
                    struct answers *answers, uint32_t begin,
                    uint32_t end)
{
    const uint32_t n = question->points.n;
    for (uint32_t i = begin; i < end; i++) {
        struct pair_distances best = {INFINITY, 0};
        uint64_t near_block = 0, far_block = 0;
        for (uint64_t block = 0; block < n; block += BLOCK) {
            uint64_t stop = MIN(n, block + BLOCK);
            //> Sweep a block and see whether it did better
            struct pair_distances before = best;
            sweep(geometry, question, i, block, MIN(stop, i), &best);
            sweep(geometry, question, i, MAX(block, i + 1), stop,
                  &best);
            if (best.near2 < before.near2)
                near_block = block;
            if (best.far2 > before.far2)
                far_block = block;
            //<
        }
        tile_answer(geometry, question, answers, i,
                    (struct winner){best.near2, best.far2, near_block,
                                    far_block});
    }
}

SPECIALIZE(blocks)
//<

//> Sweep with eight lanes
INLINED void lane_sweep(const enum geometry geometry,
                        const struct question *question, uint64_t begin,
                        uint64_t end, struct tile *tile)
{
    const double *x = question->points.x, *y = question->points.y;
    const struct space space = question->space;
    struct tile t = *tile;
    uint64_t j = begin;
    //> Compare with eight candidates at once
    for (; j + LANES <= end; j += LANES) {
#pragma omp simd
        for (int lane = 0; lane < LANES; lane++) {
            struct pair_distances pair =
                pair2(geometry, space, x[j + lane] - t.x[lane],
                      y[j + lane] - t.y[lane]);
            t.near2[lane] = MIN(pair.near2, t.near2[lane]);
            t.far2[lane] = MAX(pair.far2, t.far2[lane]);
        }
    }
    //<
    //> Give the last few to the first lane
    for (; j < end; j++) {
        struct pair_distances pair =
            pair2(geometry, space, x[j] - t.x[0], y[j] - t.y[0]);
        t.near2[0] = MIN(pair.near2, t.near2[0]);
        t.far2[0] = MAX(pair.far2, t.far2[0]);
    }
    //<
    *tile = t;
}
//<

//> Search a row with eight lanes
INLINED void lanes(const enum geometry geometry,
                   const struct question *question,
                   struct answers *answers, uint32_t begin,
                   uint32_t end)
{
    const struct points p = question->points;
    struct tile tile;
    struct blocks found;
    for (uint32_t i = begin; i < end; i++) {
        tile_begin(&tile, &found);
        for (int lane = 0; lane < LANES; lane++) {
            tile.x[lane] = p.x[i];
            tile.y[lane] = p.y[i];
        }
        for (uint64_t block = 0; block < p.n; block += BLOCK) {
            uint64_t stop = MIN(p.n, block + BLOCK);
            struct tile before = tile;
            lane_sweep(geometry, question, block, MIN(stop, i), &tile);
            lane_sweep(geometry, question, MAX(block, i + 1), stop,
                       &tile);
            tile_note(&before, &tile, block, &found);
        }
        //> Find the best of the lanes
        int near = 0, far = 0;
        for (int lane = 1; lane < LANES; lane++) {
            if (tile.near2[lane] < tile.near2[near] ||
                (tile.near2[lane] == tile.near2[near] &&
                 found.near[lane] < found.near[near]))
                near = lane;
            if (tile.far2[lane] > tile.far2[far] ||
                (tile.far2[lane] == tile.far2[far] &&
                 found.far[lane] < found.far[far]))
                far = lane;
        }
        //<
        tile_answer(geometry, question, answers, i,
                    (struct winner){tile.near2[near], tile.far2[far],
                                    found.near[near], found.far[far]});
    }
}

SPECIALIZE(lanes)
//<

//> List the steps
const struct step steps[] = {
    {"first", first_rows},     // a function is passed
    {"inlined", inlined_rows}, // the compiler sees it
    {"split", split_rows},     // no test for the point itself
    {"blocks", blocks_rows},   // distances first, indices later
    {"lanes", lanes_rows},     // eight candidates at once
    {"queries", queries_rows}, // eight queries at once
    {"tiles", tiles_rows},     // the multipliers subtract
};

const int step_count = sizeof steps / sizeof *steps;
//<
//<

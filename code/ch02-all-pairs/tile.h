//> Hold eight queries side by side
// A tile: LANES queries in lanes of their own, so that one vector
// instruction serves them all, and the search by blocks. A sweep over
// the candidates keeps distances only and notes the block in which each
// best was found; a second look at that one block finds the index. The
// rule: whenever a distance is computed, it must be the same to the
// last bit, so compile with -ffp-contract=off.
#pragma once
#include "ch02-all-pairs/pair.h"
#include "common/min_max.h"
#include <assert.h>
#include <stdbool.h>

//> Keep eight queries and their bests
enum { LANES = 8, BLOCK = 256 };

struct tile {
    double x[LANES], y[LANES];        // the queries
    double near2[LANES], far2[LANES]; // the best so far
    uint64_t distances;               // computed so far
};

struct blocks { // first candidate of the block with the best so far
    uint64_t near[LANES], far[LANES];
};
//<

//> Hold the bests of one query and their blocks
// The bests of one query, and the blocks they are in.
struct winner {
    double near2, far2;
    uint64_t near_block, far_block;
};
//<

//> Begin with nothing found
static inline void tile_begin(struct tile *tile, struct blocks *blocks)
{
    for (int lane = 0; lane < LANES; lane++) {
        tile->near2[lane] = INFINITY;
        tile->far2[lane] = 0;
        blocks->near[lane] = blocks->far[lane] = 0;
    }
    tile->distances = 0;
}
//<

//> Note the block that did better
static inline void tile_note(const struct tile *before,
                             const struct tile *after, uint64_t block,
                             struct blocks *blocks)
{
    for (int lane = 0; lane < LANES; lane++) {
        blocks->near[lane] = after->near2[lane] < before->near2[lane]
                                 ? block
                                 : blocks->near[lane];
        blocks->far[lane] = after->far2[lane] > before->far2[lane]
                                ? block
                                : blocks->far[lane];
    }
}
//<

//> Look again for the index
INLINED uint64_t find_index(const enum geometry geometry,
                            const struct question *question, uint32_t i,
                            uint64_t j, bool far, double distance2)
{
    const struct points p = question->points;
    for (;; j++) {
        assert(j < p.n && "compile with -ffp-contract=off");
        struct pair_distances pair =
            pair2(geometry, question->space, p.x[j] - p.x[i],
                  p.y[j] - p.y[i]);
        if (j != i && (far ? pair.far2 : pair.near2) == distance2)
            return j;
    }
}
//<

//> Answer from distances and blocks
// Returns how many distances were computed once more.
INLINED uint64_t tile_answer(const enum geometry geometry,
                             const struct question *question,
                             struct answers *answers, uint32_t i,
                             struct winner best)
{
    uint64_t j = find_index(geometry, question, i, best.near_block,
                            false, best.near2);
    uint64_t k = find_index(geometry, question, i, best.far_block, true,
                            best.far2);
    answers->nearest[i] = (uint32_t)j;
    answers->nearest2[i] = best.near2;
    answers->furthest[i] = (uint32_t)k;
    answers->furthest2[i] = best.far2;
    return j - best.near_block + 1 + k - best.far_block + 1;
}
//<
//<

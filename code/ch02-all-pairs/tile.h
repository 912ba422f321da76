//> Hold eight searches side by side
// LANES searches, so that one vector instruction serves several, and
// the search by blocks that they share. A sweep over the candidates
// keeps distances only, and notes the block of candidates where each
// was found; a second look at that one block finds the index. The rule:
// whenever a distance is computed, it must be the same to the last bit,
// so compile with -ffp-contract=off.
#pragma once
#include "ch02-all-pairs/pair.h"
#include "common/count.h"
#include <assert.h>
#include <stdbool.h>

enum { LANES = 8, BLOCK = 256 };

struct tile {
    double x[LANES], y[LANES];        // who asks
    double near2[LANES], far2[LANES]; // the best so far
};

struct blocks {
    uint64_t near[LANES], far[LANES]; // the first point of each
};

static inline uint64_t lesser(uint64_t a, uint64_t b)
{
    return a < b ? a : b;
}

static inline uint64_t greater(uint64_t a, uint64_t b)
{
    return a > b ? a : b;
}

//> Begin with nothing found
static inline void tile_begin(struct tile *tile, struct blocks *blocks)
{
    for (int lane = 0; lane < LANES; lane++) {
        tile->near2[lane] = INFINITY;
        tile->far2[lane] = 0;
        blocks->near[lane] = blocks->far[lane] = 0;
    }
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
INLINED uint64_t look_again(const enum geometry geometry,
                            const struct question *question, uint32_t i,
                            uint64_t j, bool far, double distance2)
{
    const struct points p = question->points;
    for (;; j++) {
        assert(j < p.n && "compile with -ffp-contract=off");
        struct pair pair = pair2(geometry, question->space,
                                 p.x[j] - p.x[i], p.y[j] - p.y[i]);
        if (j != i && (far ? pair.far2 : pair.near2) == distance2)
            return j;
    }
}
//<

//> Answer from distances and blocks
INLINED void tile_answer(const enum geometry geometry,
                         const struct question *question,
                         struct answers *answers, uint32_t i,
                         double near2, uint64_t near_block, double far2,
                         uint64_t far_block)
{
    uint64_t j =
        look_again(geometry, question, i, near_block, false, near2);
    uint64_t k =
        look_again(geometry, question, i, far_block, true, far2);
    answers->nearest[i] = (uint32_t)j;
    answers->nearest2[i] = near2;
    answers->furthest[i] = (uint32_t)k;
    answers->furthest2[i] = far2;
    COUNT(distances, j - near_block + 1 + k - far_block + 1);
}
//<
//<

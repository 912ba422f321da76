//> Declare the manners of asking
// The search of row_spans.h on one thread, in each instruction set.
#pragma once
#include "ch04-cell-sort/sorted.h"

// Eight points together; each alone, in every row of its block; alone,
// and only in those rows that can have somebody near.
enum manner { TOGETHER, ALONE, SKIPPING };

struct window;
struct tile;

// What else is asked for the points of a tile, once their nearest have
// been found. The window is NULL where none is open. What is found goes
// where the nearest of the tile went, k = tile->begin - tile->first.
struct visit {
    void (*tile)(const void *context, const struct window *window,
                 const struct tile *tile, struct answers *found);
    const void *context;
};

// Answers for the sorted points begin .. end - 1, begin < end: the
// first of them at nearest[0] and nearest2[0]. Visits every tile of
// those who ask together, if visit is not NULL.
typedef void span_search(const struct question *question,
                         const struct sorted *sorted,
                         enum manner manner, const struct visit *visit,
                         uint32_t begin, uint32_t end,
                         struct answers *found);
//<

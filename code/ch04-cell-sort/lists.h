//> Declare the lists
// A list of points for every cell (Su, figure 1). n + m steps and as
// many 32-bit numbers for n points in m cells.
#pragma once
#include "ch04-cell-sort/grid.h"

static const uint32_t NOBODY = UINT32_MAX; // the end of a list

struct lists {
    uint32_t *head; // head[0 .. m-1]: the first point of each cell
    uint32_t *next; // next[0 .. n-1]: who follows each point
};

// Released with lists_free.
struct lists lists_make(const struct grid *grid, struct points points);
void lists_free(struct lists *lists);
//<

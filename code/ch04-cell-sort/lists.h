//> Hold a list for every cell
// A list of points for every cell (Su, figure 1). n + m steps and as
// many 32-bit numbers for n points in m cells. Lists end with NO_INDEX
// and run from the highest index to the lowest.
#pragma once
#include "ch04-cell-sort/grid.h"

//> Declare the lists
struct lists {
    uint32_t *head; // head[0 .. m-1]: the first point of each cell
    uint32_t *next; // next[0 .. n-1]: the point after each point
};
//<

// Released with lists_free.
struct lists lists_make(const struct grid *grid, struct points points);
void lists_free(struct lists *lists);
//<

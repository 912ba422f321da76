//> Declare the homes
// Every point's cell, by arithmetic alone: the one part of the sort
// that vectors and threads have no trouble with.
#pragma once
#include "ch04-cell-sort/grid.h"

// Writes the cells of the points begin .. end - 1 to home[begin] and
// so on.
void find_homes(const struct grid *grid, struct points points,
                uint32_t begin, uint32_t end, uint32_t *home);

// Where share k of n points begins. Work is dealt out by shares, one
// for each thread that was asked for, however many there really are.
static inline uint32_t share_begin(uint32_t n, int k, int shares)
{
    return (uint64_t)n * k / shares;
}
//<

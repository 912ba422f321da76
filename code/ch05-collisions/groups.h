//> Declare the sort by groups
// The sort of chapter 4 as a vector machine has to do it: L points at a
// time, one in each lane (Kanada 1990; Su, figure 4). Lanes whose
// points share a cell collide: one of them wins, the losers are seen to
// one by one.
// Expected cost for n uniform points, c to a cell: n points and about
// c (L - 1) / 2 losers.
#pragma once
#include "ch04-cell-sort/cells.h"

//> Hold what a group needs
struct groups {
    uint32_t lanes;   // L >= 1
    uint32_t *ticket; // ticket[cell]: the lane that wrote there last
    uint32_t *seen;   // seen[lane]: the number that the lane read
    uint32_t *loser;  // the lanes that lost, in ascending order
};
//<

// For cells numbered 0 .. cells - 1. Released with groups_free.
struct groups groups_allocate(uint32_t lanes, uint32_t cells);
void groups_free(struct groups *groups);

// Adds the points of every cell to count[0 .. cells - 1]; cell_id[i] is
// the cell of point i < n. Returns how many points lost.
uint64_t groups_count(const struct groups *groups,
                      const uint32_t *cell_id, uint32_t n,
                      uint32_t *count);

// Writes every point's number to the next free place of its cell, in
// the order of the numbers: next[0 .. cells - 1] are places of
// point[0 .. n-1], and go on to where the next cell begins. Returns how
// many points lost.
uint64_t groups_place(const struct groups *groups,
                      const uint32_t *cell_id, uint32_t n,
                      uint32_t *next, uint32_t *point);

// The same as cells_sort, by groups of so many points. The losers are
// added to counts, which may be NULL.
struct cells cells_sort_groups(const struct grid *grid,
                               struct points points, uint32_t lanes,
                               struct counts *counts);

// All nearest neighbors, sorted by groups of 64, a Cray's vector.
search_function cells_groups;
//<

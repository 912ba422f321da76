//> Declare the sort by conflict detection
// Chapter 4's sort with eight points at a time and an instruction that
// finds out which of them share a cell (AVX-512's vpconflictd). Lanes
// that share one take places one behind the other, and none loses.
// Where the machine lacks the instruction, or NEAR_ISA forbids it,
// plain C compares every lane with those before it.
#pragma once
#include "ch04-cell-sort/cells.h"

// Adds the points of every cell to count; cell_id[i] is the cell of
// point i < n.
void conflict_count(const uint32_t *cell_id, uint32_t n,
                    uint32_t *count);

// Writes every point's number to the next free place of its cell, in
// the order of the numbers: next[cell] is a place of point[0 .. n-1],
// and goes on to where the next cell begins.
void conflict_place(const uint32_t *cell_id, uint32_t n, uint32_t *next,
                    uint32_t *point);

// The same as cells_sort.
struct cells cells_sort_conflict(const struct grid *grid,
                                 struct points points);
//<

// Exercise: a column for every lane
#pragma once
#include <stdint.h>

// A vector unit with two arrays of its own: LANES counts for each cell,
// which begin with zeros, and a place for each point.
enum { LANES = 16 };
enum array { COUNTS, PLACES };

// Given; calls are counted. For the first `lanes` lanes, 1 to LANES of
// them, at once: gather: to[l] = array[at[l]]; scatter: array[at[l]] =
// from[l]. No two lanes of a call may be at the same place.
void gather(enum array array, uint32_t lanes, const uint32_t *at,
            uint32_t *to);
void scatter(enum array array, uint32_t lanes, const uint32_t *at,
             const uint32_t *from);

// Given; to be called once. Every element of COUNTS becomes the sum of
// those before it.
void scan_counts(void);

// Writes the numbers of n points, point i in cell[i], to PLACES: by
// cell, and in ascending order inside each.
void sort_by_cell(uint32_t n, const uint32_t *cell);

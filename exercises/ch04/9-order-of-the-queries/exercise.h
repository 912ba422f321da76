// Exercise: the order of the queries
#pragma once
#include <stdint.h>

// How many rows of cells there are. Given.
uint32_t row_count(void);

// The row of a place, 0 .. row_count() - 1. Given; it counts.
uint32_t row_at(double y);

// The point that is nearest to (x, y) among those in the nine cells
// around it. Given; it counts, and notes in which order it is called.
uint32_t find_nearest(double x, double y);

// Sets nearest[q], for every query q below n, to the point that is
// found for it.
void answer_all(uint32_t n, const double *x, const double *y,
                uint32_t *nearest);

// Exercise: buckets first
#pragma once
#include <stdint.h>

// Writes the numbers of n points, point i in cell[i], to point[0 ..
// n-1]: those of cell 0 first, and so on, the lowest number first in
// each. There are so many cells, fewer than 2^24. Further memory may be
// allocated.
void sort_points(uint32_t n, uint32_t cells, const uint32_t *cell,
                 uint32_t *point);

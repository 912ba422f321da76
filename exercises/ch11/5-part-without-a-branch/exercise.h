// Exercise: part without a branch
#pragma once
#include <stdint.h>

// Orders list[0 .. n-1], numbers of values, so that those whose value
// is less than the cut come first, and says how many these are. On both
// sides they stay in their order. room has space for n numbers.
uint32_t part_list(const double *value, uint32_t *list, uint32_t n,
                   double cut, uint32_t *room);

// Exercise: the k nearest
#pragma once
#include "common/points.h"

// The k nearest neighbors of point i, the nearest first, and their
// squared distances; points at the same distance in the order of
// their indices. Both arrays have k elements, 1 <= k < n. All squared
// distances are finite.
void k_nearest(struct points points, uint32_t i, uint32_t k,
               uint32_t *neighbors, double *distances2);

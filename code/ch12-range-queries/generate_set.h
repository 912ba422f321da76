//> Declare generated sets
// Points in d dimensions from the generators of the plane: coordinates
// 0 and 1 are points of one seed, 2 and 3 of the next, and so on.
#pragma once
#include "ch12-range-queries/point_set.h"
#include "common/generate.h"
#include "common/random.h"

// The caller releases them with point_set_free.
struct point_set generate_set(const struct distribution *distribution,
                              uint32_t n, int d, uint64_t seed);

// A box whose sides have this share of those of another, 0 to 1,
// anywhere inside it.
struct range random_range(const struct range *within, int d,
                          double share, struct random *random);
//<

//> Generate points in d dimensions
// Two coordinates at a time, by the generators of the plane; an odd
// last one leaves the other out.
#include "ch12-range-queries/generate_set.h"
#include "common/points.h"

struct point_set generate_set(const struct distribution *distribution,
                              uint32_t n, int d, uint64_t seed)
{
    struct point_set set = point_set_allocate(n, d);
    struct points spare = {0};
    if (d % 2)
        spare = points_allocate(n);
    for (int k = 0; k < d; k += 2) {
        struct points two = {n, set.x[k],
                             k + 1 < d ? set.x[k + 1] : spare.y};
        distribution->fill(two, seed + k / 2);
    }
    if (d % 2)
        points_free(&spare);
    return set;
}

struct range random_range(const struct range *within, int d,
                          double share, struct random *random)
{
    struct range range = {0};
    for (int k = 0; k < d; k++) {
        const double low = within->low[k];
        const double width = within->high[k] - low;
        const double room = width * (1 - share);
        range.low[k] = low + room * random_uniform(random);
        range.high[k] = range.low[k] + width * share;
    }
    return range;
}
//<

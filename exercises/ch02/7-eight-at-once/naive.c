// One query after the other, one candidate after the other.
// expect: 4 of 10
#include "common/geometry.h"
#include "exercise.h"

void nearest_in(struct points from, struct points to, double *nearest2)
{
    for (uint32_t i = 0; i < from.n; i++) {
        double best = INFINITY;
        for (uint32_t j = 0; j < to.n; j++) {
            double d2 =
                distance2(to.x[j] - from.x[i], to.y[j] - from.y[i]);
            if (d2 < best)
                best = d2;
        }
        nearest2[i] = best;
    }
}

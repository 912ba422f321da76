// The right answer, for submissions that are right and hostile, and a
// wrong one. The tests give points for the first only.
#pragma once
#include "exercise.h"
#include <math.h>

static inline struct pair right(struct points points)
{
    struct pair best = {0, 0, INFINITY};
    for (uint32_t i = 0; i < points.n; i++)
        for (uint32_t j = i + 1; j < points.n; j++) {
            double dx = points.x[j] - points.x[i];
            double dy = points.y[j] - points.y[i];
            if (dx * dx + dy * dy < best.distance2)
                best = (struct pair){i, j, dx * dx + dy * dy};
        }
    return best;
}

static inline struct pair wrong(void)
{
    return (struct pair){0, 1, 0};
}

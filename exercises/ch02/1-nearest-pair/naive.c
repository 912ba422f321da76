// Looks at every pair twice, as (i, j) and as (j, i).
// expect: 10 of 10
// lesson: the answer
#include "common/geometry.h"
#include "exercise.h"

struct pair nearest_pair(struct points points)
{
    struct pair best = {0, 1,
                        distance2(points.x[1] - points.x[0],
                                  points.y[1] - points.y[0])};
    for (uint32_t i = 0; i < points.n; i++)
        for (uint32_t j = 0; j < points.n; j++) {
            if (i >= j)
                continue;
            double d2 = distance2(points.x[j] - points.x[i],
                                  points.y[j] - points.y[i]);
            if (d2 < best.distance2)
                best = (struct pair){i, j, d2};
        }
    return best;
}

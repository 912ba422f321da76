// The nearest pair of all, by looking at every pair once.
#include "common/geometry.h"
#include "exercise.h"

static double between(struct points points, uint32_t i, uint32_t j)
{
    return distance2(points.x[j] - points.x[i],
                     points.y[j] - points.y[i]);
}

struct pair nearest_pair(struct points points)
{
    //- solution
    struct pair best = {0, 1, between(points, 0, 1)};
    for (uint32_t i = 0; i < points.n; i++)
        for (uint32_t j = i + 1; j < points.n; j++) {
            double d2 = between(points, i, j);
            if (d2 < best.distance2)
                best = (struct pair){i, j, d2};
        }
    return best;
    //- starter
    // // Your turn: look at every pair once, and keep the best.
    // struct pair first = {0, 1, between(points, 0, 1)};
    // return first;
    //- end
}

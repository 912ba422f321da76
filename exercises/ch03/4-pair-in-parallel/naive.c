// One thread, whatever was asked for.
// expect: 0 of 10
#include "exercise.h"

struct pair nearest_pair(uint32_t n, int threads)
{
    (void)threads;
    struct pair best = {0, 1, measure(0, 1)};
    for (uint32_t i = 0; i < n; i++)
        for (uint32_t j = i + 1; j < n; j++) {
            if (i == 0 && j == 1)
                continue;
            double d2 = measure(i, j);
            if (d2 < best.distance2)
                best = (struct pair){i, j, d2};
        }
    return best;
}

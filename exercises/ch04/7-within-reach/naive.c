// Measures all pairs.
// expect: 4 of 10
#include "exercise.h"

void pairs_within(struct points points, struct space space, double r)
{
    (void)space;
    for (uint32_t i = 0; i < points.n; i++)
        for (uint32_t j = i + 1; j < points.n; j++)
            if (measure(i, j) < r * r)
                take_pair(i, j);
}

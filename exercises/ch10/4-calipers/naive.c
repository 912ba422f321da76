// Measures all pairs.
// expect: 3 of 10
#include "exercise.h"

struct pair diameter(uint32_t n)
{
    struct pair best = {0, 0, measure(0, 0)};
    for (uint32_t i = 0; i < n; i++)
        for (uint32_t j = i + 1; j < n; j++) {
            double d2 = measure(i, j);
            if (d2 > best.d2)
                best = (struct pair){i, j, d2};
        }
    return best;
}

// Measures every distance.
// expect: 4 of 10
#include "exercise.h"
#include <math.h>

uint32_t nearest_early(uint32_t n, const double *x, uint32_t i)
{
    uint32_t nearest = i;
    double nearest2 = INFINITY;
    for (uint32_t j = 0; j < n; j++) {
        if (j == i)
            continue;
        double d2 = measure(i, j);
        if (d2 < nearest2) {
            nearest = j;
            nearest2 = d2;
        }
    }
    return nearest;
}

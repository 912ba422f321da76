// Goes through the edges for every value.
// expect: 4 of 10
#include "exercise.h"

size_t histogram(const double *values, size_t n, double low,
                 double high, int bins, uint64_t *counts)
{
    size_t outside = 0;
    for (int b = 0; b < bins; b++)
        counts[b] = 0;
    for (size_t i = 0; i < n; i++) {
        if (!(values[i] >= low && values[i] <= high)) {
            outside++;
            continue;
        }
        int b = 0;
        while (b < bins - 1 &&
               values[i] >= edge(low, high, bins, b + 1))
            b++;
        counts[b]++;
    }
    return outside;
}

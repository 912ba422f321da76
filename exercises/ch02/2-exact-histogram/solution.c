// A histogram: divide to find the bin, then correct by the edges, from
// which a rounded quotient can be one bin away.
#include "exercise.h"

size_t histogram(const double *values, size_t n, double low,
                 double high, int bins, uint64_t *counts)
{
    //- solution
    size_t outside = 0;
    for (int b = 0; b < bins; b++)
        counts[b] = 0;
    for (size_t i = 0; i < n; i++) {
        double value = values[i];
        if (!(value >= low && value <= high)) {
            outside++;
            continue;
        }
        int b = (int)((value - low) / (high - low) * bins);
        if (b > bins - 1)
            b = bins - 1;
        if (value < edge(low, high, bins, b))
            b--;
        else if (b < bins - 1 && value >= edge(low, high, bins, b + 1))
            b++;
        counts[b]++;
    }
    return outside;
    //- starter
    // // Your turn. So far, every value is in no bin.
    // for (int b = 0; b < bins; b++)
    //     counts[b] = 0;
    // return n;
    //- end
}

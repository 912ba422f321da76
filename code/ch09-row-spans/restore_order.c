//> Restore the order of the input
// One pass over the results, reading in a stream for each bucket and
// writing in two.
#include "ch09-row-spans/restore_order.h"

void restore_order(const struct neighbor *results,
                   const uint32_t *permutation, uint32_t n, int threads,
                   uint32_t *index, double *distance2)
{
#pragma omp parallel for num_threads(threads)
    for (uint32_t i = 0; i < n; i++) {
        const struct neighbor result = results[permutation[i]];
        index[i] = result.index;
        distance2[i] = result.distance2;
    }
}
//<

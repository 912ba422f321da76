// Answers the queries as they come.
// expect: 3 of 10
#include "exercise.h"

void answer_all(uint32_t n, const double *x, const double *y,
                uint32_t *nearest)
{
    for (uint32_t q = 0; q < n; q++)
        nearest[q] = find_nearest(x[q], y[q]);
}

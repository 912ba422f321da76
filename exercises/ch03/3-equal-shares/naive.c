// As many rows for every thread.
// expect: 3 of 10
#include "exercise.h"

void share_rows(uint32_t n, int threads, uint32_t *first)
{
    for (int t = 0; t <= threads; t++)
        first[t] = (uint64_t)n * t / threads;
}

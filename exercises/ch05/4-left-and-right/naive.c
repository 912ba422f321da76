// One thread, whatever was asked for.
// expect: 1 of 10
#include "exercise.h"

uint32_t divide(uint32_t n, uint32_t *point, int threads)
{
    (void)threads;
    uint32_t placed = 0, lefts;
    for (uint32_t i = 0; i < n; i++)
        if (is_left(i))
            point[placed++] = i;
    lefts = placed;
    for (uint32_t i = 0; i < n; i++)
        if (!is_left(i))
            point[placed++] = i;
    return lefts;
}

//> Make room for points
// The two arrays are one block of memory: x first, then y from the
// next 64-byte line on, so that both begin where a vector may.
#include "common/points.h"
#include "common/fail.h"
#include <stdlib.h>

struct points points_allocate(uint32_t n)
{
    size_t line = 64 / sizeof(double);
    size_t stride = (n + line - 1) / line * line;
    double *x = allocate(2 * stride, sizeof *x);
    return (struct points){n, x, x + stride};
}

void points_free(struct points *points)
{
    free(points->x);
    *points = (struct points){0};
}
//<

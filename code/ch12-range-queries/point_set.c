//> Make room for a set of points
// One block of memory, in which every coordinate begins at a cache
// line.
#include "ch12-range-queries/point_set.h"
#include "common/allocate.h"
#include "common/min_max.h"
#include <stdlib.h>
#include <string.h>

static size_t stride_of(uint32_t n)
{
    return ((size_t)n + 2 * LANES - 1) / LANES * LANES;
}

struct point_set point_set_allocate(uint32_t n, int d)
{
    const size_t stride = stride_of(n);
    struct point_set points = {.n = n, .d = d};
    double *block = allocate(stride * d, sizeof *block);
    for (int k = 0; k < d; k++) {
        points.x[k] = block + k * stride;
        memset(points.x[k] + n, 0, (stride - n) * sizeof *block);
    }
    return points;
}

void point_set_free(struct point_set *points)
{
    free(points->x[0]);
    *points = (struct point_set){0};
}

size_t point_set_bytes(const struct point_set *points)
{
    return stride_of(points->n) * points->d * sizeof(double);
}

//> Find the range of some points
// Each lane keeps a least and a greatest of its own; so the compiler
// may take them all at once. What is read behind the end is not looked
// at.
static void extremes(const double *x, uint32_t n, double *low,
                     double *high)
{
    double min[LANES], max[LANES];
    for (int lane = 0; lane < LANES; lane++)
        min[lane] = max[lane] = x[0];
    uint32_t i = 0;
    for (; i + LANES <= n; i += LANES)
        for (int lane = 0; lane < LANES; lane++) {
            const double value = x[i + lane];
            min[lane] = MIN(value, min[lane]);
            max[lane] = MAX(value, max[lane]);
        }
    for (; i < n; i++) {
        min[0] = MIN(x[i], min[0]);
        max[0] = MAX(x[i], max[0]);
    }
    *low = min[0];
    *high = max[0];
    for (int lane = 1; lane < LANES; lane++) {
        *low = MIN(min[lane], *low);
        *high = MAX(max[lane], *high);
    }
}

struct range range_of(const struct point_set *points, uint32_t begin,
                      uint32_t end)
{
    struct range range = {0};
    for (int k = 0; k < points->d; k++)
        extremes(points->x[k] + begin, end - begin, &range.low[k],
                 &range.high[k]);
    return range;
}
//<

bool ranges_meet(const struct range *a, const struct range *b, int d)
{
    bool meet = true;
    for (int k = 0; k < d; k++)
        meet &= (a->low[k] <= b->high[k]) & (b->low[k] <= a->high[k]);
    return meet;
}
//<

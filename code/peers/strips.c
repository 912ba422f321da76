// See strips.h. One sort by x, then one by y in each strip: O(n log n)
// with the C library's qsort.
#include "peers/strips.h"
#include "common/fail.h"
#include <math.h>
#include <stdlib.h>

struct pair {
    double x, y;
};

static int by_x(const void *a, const void *b)
{
    const struct pair *p = a, *q = b;
    return (p->x > q->x) - (p->x < q->x);
}

static int by_y(const void *a, const void *b)
{
    const struct pair *p = a, *q = b;
    return (p->y > q->y) - (p->y < q->y);
}

struct points points_in_strips(struct points points)
{
    const uint32_t n = points.n, wide = (uint32_t)ceil(sqrt(n));
    struct points sorted = points_allocate(n);
    struct pair *pair = allocate(n, sizeof *pair);
    for (uint32_t i = 0; i < n; i++)
        pair[i] = (struct pair){points.x[i], points.y[i]};
    qsort(pair, n, sizeof *pair, by_x);
    for (size_t begin = 0; begin < n; begin += wide)
        qsort(pair + begin, n - begin < wide ? n - begin : wide,
              sizeof *pair, by_y);
    for (uint32_t i = 0; i < n; i++)
        sorted.x[i] = pair[i].x, sorted.y[i] = pair[i].y;
    free(pair);
    return sorted;
}

// Sorts all distances and copies the first k.
// expect: 4 of 10
#include "common/geometry.h"
#include "exercise.h"
#include <stdlib.h>

struct candidate {
    double distance2;
    uint32_t index;
};

static int nearer(const void *a, const void *b)
{
    const struct candidate *p = a, *q = b;
    if (p->distance2 != q->distance2)
        return p->distance2 < q->distance2 ? -1 : 1;
    return p->index < q->index ? -1 : 1;
}

void k_nearest(struct points points, uint32_t i, uint32_t k,
               uint32_t *neighbors, double *distances2)
{
    struct candidate *all = malloc(points.n * sizeof *all);
    uint32_t count = 0;
    for (uint32_t j = 0; j < points.n; j++)
        if (j != i)
            all[count++] =
                (struct candidate){distance2(points.x[j] - points.x[i],
                                             points.y[j] - points.y[i]),
                                   j};
    qsort(all, count, sizeof *all, nearer);
    for (uint32_t p = 0; p < k; p++) {
        neighbors[p] = all[p].index;
        distances2[p] = all[p].distance2;
    }
    free(all);
}

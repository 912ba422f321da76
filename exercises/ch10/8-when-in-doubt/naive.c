// The corners of the hull, without a margin.
// expect: 3 of 10
#include "exercise.h"
#include <stdlib.h>

static struct points all;

static int from_left(const void *one, const void *other)
{
    uint32_t i = *(const uint32_t *)one, j = *(const uint32_t *)other;
    if (all.x[i] != all.x[j])
        return all.x[i] < all.x[j] ? -1 : 1;
    if (all.y[i] != all.y[j])
        return all.y[i] < all.y[j] ? -1 : 1;
    return (i > j) - (i < j);
}

static double turn(uint32_t i, uint32_t j, uint32_t k)
{
    return (all.x[j] - all.x[i]) * (all.y[k] - all.y[i]) -
           (all.y[j] - all.y[i]) * (all.x[k] - all.x[i]);
}

uint32_t keep_furthest(struct points points, uint32_t *kept)
{
    all = points;
    uint32_t *order = malloc(points.n * sizeof *order);
    uint32_t *stack = malloc((points.n + 1) * sizeof *stack);
    uint32_t m = 0, count = 0;
    for (uint32_t i = 0; i < points.n; i++)
        order[i] = i;
    qsort(order, points.n, sizeof *order, from_left);
    for (uint32_t s = 0; s < points.n; s++)
        if (m == 0 || all.x[order[s]] != all.x[order[m - 1]] ||
            all.y[order[s]] != all.y[order[m - 1]])
            order[m++] = order[s];
    for (uint32_t s = 0; s < m; s++) {
        while (count > 1 &&
               turn(stack[count - 2], stack[count - 1], order[s]) <= 0)
            count--;
        stack[count++] = order[s];
    }
    uint32_t lower = count;
    for (uint32_t s = m - 1; s-- > 0;) {
        while (count > lower &&
               turn(stack[count - 2], stack[count - 1], order[s]) <= 0)
            count--;
        stack[count++] = order[s];
    }
    count = m == 1 ? 1 : count - 1;
    for (uint32_t c = 0; c < count; c++)
        kept[c] = stack[c];
    free(order);
    free(stack);
    return count;
}

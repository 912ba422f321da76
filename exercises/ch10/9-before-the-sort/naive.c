// Sorts all points and makes the hull.
// expect: 4 of 10
#include "exercise.h"
#include <stdlib.h>

struct place {
    double x, y;
    uint32_t index;
};

static int from_left(const void *one, const void *other)
{
    const struct place *p = one, *q = other;
    if (p->x != q->x)
        return p->x < q->x ? -1 : 1;
    if (p->y != q->y)
        return p->y < q->y ? -1 : 1;
    return (p->index > q->index) - (p->index < q->index);
}

static uint32_t put(const struct place *p, uint32_t *stack,
                    uint32_t count, uint32_t low, uint32_t k)
{
    while (count > low) {
        const struct place *a = &p[stack[count - 2]];
        const struct place *b = &p[stack[count - 1]];
        if ((b->x - a->x) * (p[k].y - a->y) -
                (b->y - a->y) * (p[k].x - a->x) >
            0)
            break;
        count--;
    }
    stack[count] = k;
    return count + 1;
}

uint32_t throw_away(struct points points, uint32_t *kept)
{
    struct place *p = malloc(points.n * sizeof *p);
    uint32_t *stack = malloc((points.n + 1) * sizeof *stack);
    uint32_t m = 0, count = 0;
    for (uint32_t i = 0; i < points.n; i++)
        p[i] = (struct place){points.x[i], points.y[i], i};
    qsort(p, points.n, sizeof *p, from_left);
    for (uint32_t s = 0; s < points.n; s++)
        if (m == 0 || p[s].x != p[m - 1].x || p[s].y != p[m - 1].y)
            p[m++] = p[s];
    for (uint32_t s = 0; s < m; s++)
        count = put(p, stack, count, 1, s);
    uint32_t lower = count;
    for (uint32_t s = m - 1; s-- > 0;)
        count = put(p, stack, count, lower, s);
    count = m == 1 ? 1 : count - 1;
    for (uint32_t c = 0; c < count; c++)
        kept[c] = p[stack[c]].index;
    free(p);
    free(stack);
    return count;
}

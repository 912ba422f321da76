// Andrew's chains: from left to right a stack of points that turn left,
// then back again on top of it. The furthest point is among them.
#include "exercise.h"
#include <stdlib.h>

//- solution
// Keeps one of those in the same place, the lowest index.
static uint32_t drop_duplicates(struct points points, uint32_t *order)
{
    uint32_t m = 1;
    for (uint32_t s = 1; s < points.n; s++) {
        uint32_t i = order[m - 1], j = order[s];
        if (points.x[i] != points.x[j] || points.y[i] != points.y[j])
            order[m++] = j;
    }
    return m;
}

// Puts j on a stack, but not before all have gone that would not turn
// left. Those below low stay.
static uint32_t put(struct points points, uint32_t *corner,
                    uint32_t count, uint32_t low, uint32_t j)
{
    while (count > low &&
           turn(points, corner[count - 2], corner[count - 1], j) <= 0)
        count--;
    corner[count] = j;
    return count + 1;
}

//- starter
//- end
uint32_t find_corners(struct points points, uint32_t *corner)
{
    //- solution
    uint32_t *order = malloc(points.n * sizeof *order);
    if (!order)
        abort();
    sort_by_x(points, order);
    uint32_t m = drop_duplicates(points, order);
    uint32_t count = 0;
    for (uint32_t s = 0; s < m; s++)
        count = put(points, corner, count, 1, order[s]);
    uint32_t lower = count;
    for (uint32_t s = m - 1; s-- > 0;)
        count = put(points, corner, count, lower, order[s]);
    free(order);
    return m == 1 ? 1 : count - 1;
    //- starter
    // // Your turn: so far every point is a corner.
    // sort_by_x(points, corner);
    // return points.n;
    //- end
}

uint32_t furthest(struct points points, const uint32_t *corner,
                  uint32_t count, uint32_t i)
{
    //- solution
    uint32_t best = corner[0];
    double best2 = measure(points, i, best);
    for (uint32_t c = 1; c < count; c++) {
        uint32_t j = corner[c];
        double d2 = measure(points, i, j);
        if (d2 > best2 || (d2 == best2 && j < best)) {
            best = j;
            best2 = d2;
        }
    }
    return best;
    //- starter
    // // Your turn: so far it is the first one.
    // return corner[0];
    //- end
}

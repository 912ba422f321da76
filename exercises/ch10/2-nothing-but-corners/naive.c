// Wraps the points as one wraps a gift, from corner to corner.
// expect: 4 of 10
#include "exercise.h"

static double apart2(struct points p, uint32_t i, uint32_t j)
{
    double dx = p.x[j] - p.x[i], dy = p.y[j] - p.y[i];
    return dx * dx + dy * dy;
}

static uint32_t next_corner(struct points p, uint32_t i)
{
    uint32_t best = i;
    for (uint32_t k = 0; k < p.n; k++) {
        if (apart2(p, i, k) == 0)
            continue;
        double bend = best == i ? -1 : turn(p, i, best, k);
        if (bend < 0 ||
            (bend == 0 && apart2(p, i, k) > apart2(p, i, best)))
            best = k;
    }
    return best;
}

uint32_t find_corners(struct points points, uint32_t *corner)
{
    uint32_t first = 0, count = 0;
    for (uint32_t i = 1; i < points.n; i++)
        if (points.x[i] < points.x[first] ||
            (points.x[i] == points.x[first] &&
             points.y[i] < points.y[first]))
            first = i;
    uint32_t i = first;
    do {
        corner[count++] = i;
        i = next_corner(points, i);
    } while (i != first && apart2(points, i, first) > 0);
    return count;
}

uint32_t furthest(struct points points, const uint32_t *corner,
                  uint32_t count, uint32_t i)
{
    uint32_t best = corner[0];
    double best2 = measure(points, i, best);
    for (uint32_t c = 1; c < count; c++) {
        double d2 = measure(points, i, corner[c]);
        if (d2 > best2 || (d2 == best2 && corner[c] < best)) {
            best = corner[c];
            best2 = d2;
        }
    }
    return best;
}

// Rounds the points of a circle.
// expect: 2 of 10
#include "exercise.h"
#include <math.h>

void worst_case(struct points points, uint32_t side)
{
    double half = side / 2.0;
    for (uint32_t i = 0; i < points.n; i++) {
        double angle = 8 * atan(1) * i / points.n;
        points.x[i] = round(half + half * cos(angle));
        points.y[i] = round(half + half * sin(angle));
    }
}

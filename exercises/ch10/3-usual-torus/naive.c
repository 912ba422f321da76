// Looks at all cells and measures all points.
// expect: 3 of 10
#include "exercise.h"

uint32_t furthest_on_torus(struct box box, double x, double y)
{
    uint32_t best = UINT32_MAX;
    double best2 = -1;
    (void)x, (void)y;
    for (uint32_t row = 0; row < box.rows; row++)
        for (uint32_t column = 0; column < box.columns; column++) {
            struct span span = look(column, row);
            for (uint32_t s = span.begin; s < span.end; s++) {
                double d2 = measure(s);
                if (d2 > best2) {
                    best = s;
                    best2 = d2;
                }
            }
        }
    return best;
}

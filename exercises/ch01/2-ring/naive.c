// Throws points into a square until one falls into the ring.
// expect: 10 of 10
// lesson: the answer
#include "common/random.h"
#include "exercise.h"

void fill_ring(struct points points, double inner, double outer,
               uint64_t seed)
{
    struct random random = {seed};
    for (uint32_t i = 0; i < points.n; i++) {
        double x, y, r2;
        do {
            x = outer * (2 * random_uniform(&random) - 1);
            y = outer * (2 * random_uniform(&random) - 1);
            r2 = x * x + y * y;
        } while (r2 < inner * inner || r2 > outer * outer);
        points.x[i] = x;
        points.y[i] = y;
    }
}

// Points in a ring, evenly by area: the area within radius r grows with
// the square of r, so it is the square that is drawn evenly.
#include "common/random.h"
#include "exercise.h"
#include <math.h>

void fill_ring(struct points points, double inner, double outer,
               uint64_t seed)
{
    //- solution
    struct random random = {seed};
    for (uint32_t i = 0; i < points.n; i++) {
        double u = random_uniform(&random);
        double r =
            sqrt(inner * inner + u * (outer * outer - inner * inner));
        double x, y;
        random_direction(&random, &x, &y);
        points.x[i] = r * x;
        points.y[i] = r * y;
    }
    //- starter
    // // Your turn. So far: a square around the origin, hole and all.
    // struct random random = {seed};
    // for (uint32_t i = 0; i < points.n; i++) {
    //     points.x[i] = outer * (2 * random_uniform(&random) - 1);
    //     points.y[i] = outer * (2 * random_uniform(&random) - 1);
    // }
    //- end
}

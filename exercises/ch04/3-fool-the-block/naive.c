// Uniform random points, of which the block gets a few wrong.
// expect: 2 of 10
#include "common/random.h"
#include "exercise.h"

void fool_the_block(struct points points)
{
    struct random random = {1};
    for (uint32_t i = 0; i < points.n; i++) {
        points.x[i] = COLUMNS * random_uniform(&random);
        points.y[i] = ROWS * random_uniform(&random);
    }
}

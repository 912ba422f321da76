// Watch the vector empty.
// How many of the points of a picture are still on their way after so
// many steps, of every hundred.
//
//     emptying [WIDTH [LIMIT]]
#include "ch06-pack-scan/escape.h"
#include "common/experiment.h"

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t width = parameter(&e, "WIDTH", 480, 4, 10000);
    uint32_t limit = parameter(&e, "LIMIT", 1024, 1, MANY);
    struct points c = picture(width, width / 4 * 3);
    struct lanes lanes = lanes_allocate(c.n);
    double *steps = take(c.n, sizeof *steps);
    escape(primitives(isa_chosen()), c, limit, 32, &lanes, steps);
    // How many took k steps; those of limit may have gone on.
    uint32_t *ended = take(limit + 1, sizeof *ended);
    for (uint32_t i = 0; i < c.n; i++)
        ended[(uint32_t)steps[i]]++;
    columns(&e, "name step percent");
    uint32_t active = c.n, next = 1;
    for (uint32_t k = 0; k < limit; k++) {
        active -= ended[k];
        if (k + 1 < next)
            continue;
        row("after_%u\t%u\t%.4f", k + 1, k + 1, 100.0 * active / c.n);
        next = k + 1 + (k + 1) / 8 + 1;
    }
    return 0;
}

// Close points make orthotrees deep: a thousand even points in space,
// and twenty more that lie in a cube with a side of 2^-j. Nodes of both
// forms, and the nodes that a query visits whose box is that cube.
//
//     depth
#include "ch12-range-queries/generate_set.h"
#include "ch12-range-queries/orthotree.h"
#include "common/experiment.h"
#include <inttypes.h>
#include <math.h>

enum { EVEN = 1000, CLOSE = 20, D = 3 };

static uint64_t steps_of(const struct orthotree *tree, double side)
{
    uint32_t found[EVEN + CLOSE];
    struct report report = {found};
    struct range box = {0};
    for (int k = 0; k < D; k++) {
        box.low[k] = 1 / 3.0;
        box.high[k] = 1 / 3.0 + side;
    }
    ortho_query(tree, &box, &report);
    return report.steps;
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    print_header(&e, "name j nodes compressed steps compressed_steps");
    for (int j = 4; j <= 20; j += 4) {
        const double side = ldexp(1, -j);
        struct point_set points = generate_set(
            find_distribution("uniform"), EVEN + CLOSE, D, 1);
        struct random random = {43};
        for (int k = 0; k < D; k++)
            for (int i = EVEN; i < EVEN + CLOSE; i++)
                points.x[k][i] =
                    1 / 3.0 + side * random_uniform(&random);
        struct orthotree plain =
            ortho_make(&points, ORTHO_LEAF_SIZE, false);
        struct orthotree compressed =
            ortho_make(&points, ORTHO_LEAF_SIZE, true);
        row("close_%d\t%d\t%u\t%u\t%" PRIu64 "\t%" PRIu64, j, j,
            plain.count, compressed.count, steps_of(&plain, side),
            steps_of(&compressed, side));
        ortho_free(&plain);
        ortho_free(&compressed);
        point_set_free(&points);
    }
}

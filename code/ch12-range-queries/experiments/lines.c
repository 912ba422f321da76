// The worst of boxes: as wide as the range along all coordinates but
// one, and without any width there; it holds no point. What a query
// looks at in the plane and in space, over the number of points, beside
// what is predicted for leaves that are cubes.
//
//     lines [LARGEST]
#include "ch12-range-queries/experiments/probe.h"
#include "ch12-range-queries/kd_tree.h"
#include <math.h>

static double leaves_of(uint32_t n)
{
    double leaves = 1;
    while (floor((n - 1) / leaves) >= KD_LEAF)
        leaves *= 2;
    return leaves;
}

// Flat along one coordinate after the other.
static void flat_boxes(struct probe *probe)
{
    const int d = probe->points.d;
    struct random random = {41};
    for (int q = 0; q < MOST_BOXES; q++) {
        const int k = q % d;
        const double low = probe->all.low[k];
        const double width = probe->all.high[k] - low;
        probe->box[q] = probe->all;
        probe->box[q].low[k] = probe->box[q].high[k] =
            low + width * random_uniform(&random);
    }
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    const uint32_t largest =
        parameter(&e, "LARGEST", 100000, 1000, MANY);
    const struct structure *s = find_structure("kd-tree");
    columns(&e, "name d n leaves predicted tested steps found");
    for (int d = 2; d <= 3; d++)
        for (uint32_t n = 1000; n <= largest; n *= 10) {
            struct probe *probe = probe_of("uniform", n, d);
            flat_boxes(probe);
            const struct report sum = ask_all(probe, s);
            const double leaves = leaves_of(n);
            row("line_%dd_%u\t%d\t%u\t%.0f\t%.5g\t%.5g\t%.5g\t%u", d, n,
                d, n, leaves, n * pow(leaves, -1.0 / d),
                sum.tested / (double)MOST_BOXES,
                sum.steps / (double)MOST_BOXES, sum.count);
            probe_free(probe);
        }
}

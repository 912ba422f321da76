// The worst of boxes: as wide as the range along all coordinates but
// one, and without any width there; it holds no point. What a query
// looks at in the plane and in space, over the number of points, beside
// what is predicted for leaves that are cubes. Last, cubes that hold a
// hundred points in eight dimensions: a thousand, where the program
// dimensions has time for a dozen.
//
//     lines [LARGEST]
#include "ch12-range-queries/experiments/query_workload.h"
#include "ch12-range-queries/kd_tree.h"
#include "common/min_max.h"
#include <math.h>

static double leaves_of(uint32_t n)
{
    double leaves = 1;
    while (floor((n - 1) / leaves) >= KD_LEAF_SIZE)
        leaves *= 2;
    return leaves;
}

// Flat along one coordinate after the other.
static void flat_boxes(struct query_workload *workload)
{
    const int d = workload->points.d;
    struct random random = {41};
    for (int q = 0; q < MAX_BOXES; q++) {
        const int k = q % d;
        const double low = workload->all.low[k];
        const double width = workload->all.high[k] - low;
        workload->box[q] = workload->all;
        workload->box[q].low[k] = workload->box[q].high[k] =
            low + width * random_uniform(&random);
    }
}

// How many of the equal parts of the range a box meets on average,
// along one coordinate, if it lies in the range as a whole: one, and
// one more for each border that is in the box.
static double parts_met(int parts, double share)
{
    const double room = 1 - share;
    double met = 1;
    for (int k = 1; k < parts; k++) {
        const double border = (double)k / parts;
        met += (MIN(border, room) - MAX(border - share, 0)) / room;
    }
    return met;
}

// With 2^15 leaves seven coordinates are cut twice, and one once.
static void print_eight(const struct structure *s)
{
    enum { N = 300000, HELD = 100 };
    const double share = pow((double)HELD / N, 1.0 / 8);
    struct query_workload *workload = workload_of("uniform", N, 8);
    boxes_anywhere(workload, share);
    const struct report sum = ask_all(workload, s);
    const double met =
        pow(parts_met(4, share), 7) * parts_met(2, share);
    row("cube_8d\t8\t%u\t%.0f\t%.5g\t%.5g\t%.5g\t%u", N, leaves_of(N),
        N / leaves_of(N) * met, sum.tested / (double)MAX_BOXES,
        sum.steps / (double)MAX_BOXES, sum.count);
    workload_free(workload);
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    const uint32_t largest =
        parameter(&e, "LARGEST", 100000, 1000, MANY);
    const struct structure *s = find_structure("kd-tree");
    print_header(&e, "name d n leaves predicted tested steps found");
    for (int d = 2; d <= 3; d++)
        for (uint32_t n = 1000; n <= largest; n *= 10) {
            struct query_workload *workload =
                workload_of("uniform", n, d);
            flat_boxes(workload);
            const struct report sum = ask_all(workload, s);
            const double leaves = leaves_of(n);
            row("line_%dd_%u\t%d\t%u\t%.0f\t%.5g\t%.5g\t%.5g\t%u", d, n,
                d, n, leaves, n * pow(leaves, -1.0 / d),
                sum.tested / (double)MAX_BOXES,
                sum.steps / (double)MAX_BOXES, sum.count);
            workload_free(workload);
        }
    print_eight(s);
}

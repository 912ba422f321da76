// Which structure is the fastest, over the number of points and the
// number that a box holds, where each box is a new question to points
// that stay, and where they move after so many boxes.
//
//     map [LARGEST [TRIALS]]
#include "ch12-range-queries/experiments/query_workload.h"
#include <math.h>

static const double shares[] = {0.003, 0.01, 0.03, 0.1, 0.3, 1};
static const double boxes_a_step[] = {INFINITY, 100, 1};

// The structure with the least time for a box, with its part of the
// time to build.
static void print_best(struct query_workload *workload,
                       const double *build_ns, void *const *built,
                       double share, int trials)
{
    double ns[16];
    boxes_anywhere(workload, share);
    double found = 0;
    for (int row = 0; row < structure_count; row++) {
        const struct cost cost =
            ask_boxes(workload, &structures[row], built[row], trials);
        ns[row] = cost.ns.median;
        found = cost.found;
    }
    row_begin("at_%u_%g\t%u\t%g\t%.4g", workload->points.n,
              1000 * share, workload->points.n, share, found);
    for (int k = 0; k < COUNT_OF(boxes_a_step); k++) {
        int best = 0;
        double min_ns = INFINITY;
        for (int row = 0; row < structure_count; row++) {
            const double each =
                ns[row] + build_ns[row] / boxes_a_step[k];
            if (each < min_ns) {
                min_ns = each;
                best = row;
            }
        }
        row_cells("\t%s\t%d\t%.4g", structures[best].name, best,
                  min_ns);
    }
    row_end();
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    const uint32_t largest =
        parameter(&e, "LARGEST", 10000, 1000, MANY);
    const int trials = parameter(&e, "TRIALS", 1, 1, MAX_TRIALS);
    print_header(&e,
                 "name n share found stays stays_row stays_ns hundred "
                 "hundred_row hundred_ns one one_row one_ns");
    for (uint32_t n = 100; n <= largest; n *= 10) {
        struct query_workload *workload = workload_of("uniform", n, 3);
        void *built[16];
        double build_ns[16];
        for (int row = 0; row < structure_count; row++) {
            const int64_t start = clock_ns();
            built[row] = structures[row].build(&workload->points, 1);
            build_ns[row] = clock_ns() - start;
        }
        for (int k = 0; k < COUNT_OF(shares); k++)
            print_best(workload, build_ns, built, shares[k], trials);
        for (int row = 0; row < structure_count; row++)
            structures[row].discard(built[row]);
        workload_free(workload);
    }
}

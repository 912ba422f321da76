// The time of a query, and its work, in one to eight dimensions: boxes
// that hold a hundred of the points on average.
//
//     dimensions [POINTS [TRIALS]]
#include "ch12-range-queries/experiments/query_workload.h"
#include <math.h>

enum { HELD = 100 };

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    const uint32_t n = parameter(&e, "POINTS", 30000, 1000, MANY);
    const int trials = parameter(&e, "TRIALS", 3, 1, MAX_TRIALS);
    print_header(&e,
                 "name structure d n share found tested steps ns:3");
    for (int d = 1; d <= MAX_DIMENSIONS; d++) {
        const double share = pow((double)HELD / n, 1.0 / d);
        struct query_workload *workload = workload_of("uniform", n, d);
        boxes_anywhere(workload, share);
        for (int row = 0; row < structure_count; row++) {
            const struct structure *s = &structures[row];
            const struct cost cost = build_and_ask(workload, s, trials);
            row_begin("%s_%dd\t%s\t%d\t%u\t%.4g\t%.5g\t%.5g\t%.5g",
                      s->name, d, s->name, d, n, share, cost.found,
                      cost.tested, cost.steps);
            row_times(&cost.ns, 1);
            row_end();
        }
        workload_free(workload);
    }
}

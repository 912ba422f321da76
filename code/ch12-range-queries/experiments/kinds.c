// What each structure costs with points of several kinds: nanoseconds
// and bytes a point to build, and the time and work of a box around a
// point that reaches to its twentieth neighbor.
//
//     kinds [POINTS [TRIALS]]
#include "ch12-range-queries/experiments/query_workload.h"

enum { NEIGHBORS = 20 };

static const char *const kinds[] = {"uniform", "clustered", "kuzmin",
                                    "two-clusters", "outlier"};

static void print_row(struct query_workload *workload, const char *kind,
                      const struct structure *s, int trials)
{
    const double n = workload->points.n;
    double ns[MAX_TRIALS];
    void *built = NULL;
    for (int trial = -1; trial < trials; trial++) {
        if (built)
            s->discard(built);
        const int64_t start = clock_ns();
        built = s->build(&workload->points, 1);
        if (trial >= 0)
            ns[trial] = clock_ns() - start;
    }
    const struct summary build = summarize(ns, trials);
    const struct cost cost = ask_boxes(workload, s, built, trials);
    row_begin("%s_%s\t%s\t%s\t%.0f\t%.4g", s->name, kind, s->name, kind,
              n, s->bytes(built) / n);
    row_times(&build, n);
    row_cells("\t%.5g\t%.5g\t%.5g", cost.found, cost.tested,
              cost.steps);
    row_times(&cost.ns, 1);
    row_end();
    s->discard(built);
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    const uint32_t n = parameter(&e, "POINTS", 30000, 1000, MANY);
    const int trials = parameter(&e, "TRIALS", 3, 1, MAX_TRIALS);
    print_header(&e, "name structure kind n bytes build:3 found tested "
                     "steps ns:3");
    for (int kind = 0; kind < COUNT_OF(kinds); kind++) {
        struct query_workload *workload =
            workload_of(kinds[kind], n, 3);
        boxes_around_points(workload, NEIGHBORS);
        for (int row = 0; row < structure_count; row++)
            print_row(workload, kinds[kind], &structures[row], trials);
        workload_free(workload);
    }
}

// The time to build the k-d tree by one thread and by more, even points
// in three dimensions.
//
//     threads [POINTS [TRIALS]]
#include "ch12-range-queries/experiments/query_workload.h"
#include "ch12-range-queries/kd_tree.h"

static struct summary build_by(const struct point_set *points,
                               int threads, int trials)
{
    double ns[MAX_TRIALS];
    for (int trial = -1; trial < trials; trial++) {
        const int64_t start = clock_ns();
        struct kd_tree tree = kd_make(points, KD_LEAF_SIZE, threads);
        if (trial >= 0)
            ns[trial] = clock_ns() - start;
        kd_free(&tree);
    }
    return summarize(ns, trials);
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    const uint32_t n = parameter(&e, "POINTS", 30000, 1000, MANY);
    const int trials = parameter(&e, "TRIALS", 3, 1, MAX_TRIALS);
    struct query_workload *workload = workload_of("uniform", n, 3);
    print_header(&e, "name threads n build:3");
    for (int threads = 1; threads <= omp_get_num_procs();
         threads *= 2) {
        const struct summary build =
            build_by(&workload->points, threads, trials);
        row_begin("build_by_%d\t%d\t%u", threads, threads, n);
        row_times(&build, n);
        row_end();
    }
    workload_free(workload);
}

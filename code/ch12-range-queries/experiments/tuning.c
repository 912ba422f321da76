// Points in a leaf of the k-d tree, and in a cell: the time to build,
// bytes a point, and the time of a query with boxes of two sizes.
//
//     tuning [POINTS [TRIALS]]
#include "ch12-range-queries/cell_array.h"
#include "ch12-range-queries/experiments/query_workload.h"
#include "ch12-range-queries/kd_tree.h"
#include <math.h>

static const double held[] = {10, 1000};

static void *make(const char *name, const struct point_set *points,
                  int size)
{
    void *made;
    if (strcmp(name, "kd-tree") == 0) {
        struct kd_tree *tree = made = allocate(1, sizeof *tree);
        *tree = kd_make(points, size, 1);
    } else {
        struct cell_array *cells = made = allocate(1, sizeof *cells);
        *cells = cell_array_make(points, size,
                                 strcmp(name, "cells-halves") == 0);
    }
    return made;
}

static void print_size(struct query_workload *workload,
                       const char *name, int size, int trials)
{
    const struct structure *s = find_structure(name);
    const uint32_t n = workload->points.n;
    int64_t start = clock_ns();
    void *built = make(name, &workload->points, size);
    const double build_ns = clock_ns() - start;
    row_begin("%s_of_%d\t%s\t%d\t%u\t%.4g\t%.4g", name, size, name,
              size, n, build_ns / n, (double)s->bytes(built) / n);
    for (int k = 0; k < COUNT_OF(held); k++) {
        boxes_anywhere(workload,
                       pow(held[k] / n, 1.0 / workload->points.d));
        const struct cost cost = ask_boxes(workload, s, built, trials);
        row_cells("\t%.5g", cost.tested);
        row_times(&cost.ns, 1);
    }
    row_end();
    s->discard(built);
}

int main(int argc, char **argv)
{
    static const char *const names[] = {"kd-tree", "cells",
                                        "cells-halves"};
    struct experiment e = experiment_begin(argc, argv);
    const uint32_t n = parameter(&e, "POINTS", 30000, 1000, MANY);
    const int trials = parameter(&e, "TRIALS", 3, 1, MAX_TRIALS);
    struct query_workload *workload = workload_of("uniform", n, 3);
    print_header(&e, "name structure size n build bytes small_tested "
                     "small:3 large_tested large:3");
    for (int k = 0; k < COUNT_OF(names); k++)
        for (int size = 2; size <= 128; size *= 2)
            print_size(workload, names[k], size, trials);
    workload_free(workload);
}

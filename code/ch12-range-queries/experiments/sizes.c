// The time of a query, and its work, over the size of the box: every
// structure, even points in three dimensions. Beside the points that
// are looked at, how many are predicted.
//
//     sizes [POINTS [TRIALS]]
#include "ch12-range-queries/cell_array.h"
#include "ch12-range-queries/experiments/query_workload.h"
#include "ch12-range-queries/kd_tree.h"
#include "ch12-range-queries/orthotree.h"
#include <math.h>

static const double shares[] = {0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1};

// Of cubes that cut the unit cube in m: so many points in those that
// are at the border of the box. With searched, a row needs no look at
// its ends.
static double at_border(double n, double m, double share, bool searched)
{
    const double sides = share * cbrt(m), inner = fmax(sides - 1, 0);
    const double outer = fmin(sides + 1, cbrt(m));
    return share == 1 ? 0
           : searched ? n / m * sides * (outer * outer - inner * inner)
                      : n / m * (pow(outer, 3) - pow(inner, 3));
}

static double predict(const char *name, double n, double share)
{
    const double slabs = floor(cbrt(n / POINTS_PER_CELL) + 1e-9);
    double looked_at = n; // the scans
    if (strcmp(name, "projection") == 0)
        looked_at = n * share;
    else if (strncmp(name, "kd-tree", 7) == 0)
        looked_at = at_border(n, exp2(ceil(log2(n / KD_LEAF_SIZE))),
                              share, false);
    else if (strncmp(name, "orthotree", 9) == 0)
        looked_at =
            at_border(n, pow(8, ceil(log2(n / ORTHO_LEAF_SIZE) / 3)),
                      share, false);
    else if (strncmp(name, "cells", 5) == 0)
        looked_at = at_border(n, pow(slabs, 3), share,
                              strcmp(name, "cells-halves") == 0);
    return looked_at;
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    const uint32_t n = parameter(&e, "POINTS", 30000, 1000, MANY);
    const int trials = parameter(&e, "TRIALS", 3, 1, MAX_TRIALS);
    struct query_workload *workload = workload_of("uniform", n, 3);
    print_header(&e, "name structure share n found tested predicted "
                     "steps ns:3");
    for (int row = 0; row < structure_count; row++) {
        const struct structure *s = &structures[row];
        void *built = s->build(&workload->points, 1);
        for (int k = 0; k < COUNT_OF(shares); k++) {
            boxes_anywhere(workload, shares[k]);
            const struct cost cost =
                ask_boxes(workload, s, built, trials);
            row_begin("%s_%g\t%s\t%g\t%u\t%.5g\t%.5g\t%.5g\t%.5g",
                      s->name, 100 * shares[k], s->name, shares[k], n,
                      cost.found, cost.tested,
                      predict(s->name, n, shares[k]), cost.steps);
            row_times(&cost.ns, 1);
            row_end();
        }
        s->discard(built);
    }
    workload_free(workload);
}

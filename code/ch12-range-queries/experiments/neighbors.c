// What a search looks at for the eight nearest of a point, and for all
// within the distance at which eight are expected: nodes or cells, and
// points, even ones in three dimensions.
//
//     neighbors [POINTS]
#include "ch12-range-queries/experiments/query_workload.h"
#include <math.h>

enum { WANTED = 8 };

static struct neighbor_query ask(const struct structure *s,
                                 const void *built,
                                 struct query_workload *workload,
                                 double distance, struct found *found)
{
    struct neighbor_query sum = {.self = NO_INDEX};
    struct random random = {47};
    for (int q = 0; q < MAX_BOXES; q++) {
        const uint32_t i = random_bits(&random) % workload->points.n;
        double place[MAX_DIMENSIONS];
        for (int k = 0; k < workload->points.d; k++)
            place[k] = workload->points.x[k][i];
        struct neighbor_query query = {
            .at = place, .self = i, .found = found};
        if (distance > 0)
            want_within(&query, distance);
        else
            want_nearest(&query, WANTED);
        s->neighbors(built, &query);
        sum.steps += query.steps;
        sum.tested += query.tested;
        sum.count += query.count;
    }
    return sum;
}

int main(int argc, char **argv)
{
    static const char *const names[] = {"kd-tree", "cells"};
    struct experiment e = experiment_begin(argc, argv);
    const uint32_t n = parameter(&e, "POINTS", 30000, 1000, MANY);
    struct query_workload *workload = workload_of("uniform", n, 3);
    struct found *found = take(n, sizeof *found);
    const double distance = cbrt(WANTED / (n * 4.18879020478639));
    const double each = MAX_BOXES;
    print_header(&e, "name n steps tested within_steps within_tested "
                     "within_found");
    for (int k = 0; k < COUNT_OF(names); k++) {
        const struct structure *s = find_structure(names[k]);
        void *built = s->build(&workload->points, 1);
        const struct neighbor_query nearest =
            ask(s, built, workload, 0, found);
        const struct neighbor_query within =
            ask(s, built, workload, distance, found);
        row("neighbors_%s\t%u\t%.4g\t%.4g\t%.4g\t%.4g\t%.4g", names[k],
            n, nearest.steps / each, nearest.tested / each,
            within.steps / each, within.tested / each,
            within.count / each);
        s->discard(built);
    }
    workload_free(workload);
}

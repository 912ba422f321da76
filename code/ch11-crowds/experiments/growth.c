// Distances a point, near and far, in both geometries, of points of
// every kind: how do they grow with n? Beside them those of one grid,
// for as many points as one has the patience for. Counts only.
//
//     growth [MOST [PATIENCE]]
#include "algorithms.h"
#include "common/experiment.h"
#include "common/generate.h"
#include <math.h>

static struct question question_of(struct points p,
                                   enum geometry geometry)
{
    double x0 = 0, y0 = 0, x1 = 1, y1 = 1;
    for (uint32_t i = 0; i < p.n; i++) {
        x0 = fmin(x0, p.x[i]), x1 = fmax(x1, p.x[i]);
        y0 = fmin(y0, p.y[i]), y1 = fmax(y1, p.y[i]);
    }
    return (struct question){p, {geometry, x1 - x0, y1 - y0}, 1};
}

static double distances(const char *name, const struct question *q,
                        unsigned answer)
{
    struct answers answers = answers_for(q->points.n, answer);
    const struct counts counts =
        count_operations(find_algorithm(name), q, &answers);
    answers_free(&answers);
    return (double)counts.distances / q->points.n;
}

static void print_kind(const struct distribution *kind, uint32_t n,
                       uint32_t patience)
{
    struct points points = generate(kind, n, 1);
    const struct question plain = question_of(points, STANDARD);
    const struct question torus = question_of(points, WRAPAROUND);
    row_begin("%s_%u\t%u", kind->name, n, n);
    row_cells("\t%.5g", distances("adaptive", &plain, NEAREST));
    row_cells("\t%.5g", distances("adaptive", &plain, FURTHEST));
    row_cells("\t%.5g", distances("adaptive", &torus, NEAREST));
    row_cells("\t%.5g", distances("adaptive", &torus, FURTHEST));
    row_cells("\t%.5g", n <= patience
                            ? distances("row-spans", &plain, NEAREST)
                            : NAN);
    row_end();
    points_free(&points);
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t most = parameter(&e, "MOST", 10000, 1000, MANY);
    uint32_t patience = parameter(&e, "PATIENCE", 10000, 1000, MANY);
    print_header(&e, "name n near far near_around far_around one_grid");
    for (int d = 0; d < distribution_count; d++)
        for (uint32_t n = 1000; n <= most; n *= 10)
            print_kind(&distributions[d], n, patience);
    return 0;
}

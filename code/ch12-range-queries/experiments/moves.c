// How many shifts an insertion takes when the points of a projection
// have moved once, for each point and coordinate, beside what is
// predicted.
//
//     moves [POINTS]
#include "ch12-range-queries/experiments/query_workload.h"
#include "ch12-range-queries/projection.h"
#include <math.h>

enum { DIMENSIONS = 3 };

// In units of the mean spacing of the points.
static const double lengths[] = {0, 0.0001, 0.001, 0.01, 0.1};

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    const uint32_t n = parameter(&e, "POINTS", 30000, 1000, MANY);
    print_header(&e, "name length n predicted moves");
    for (int k = 0; k < COUNT_OF(lengths); k++) {
        struct query_workload *workload =
            workload_of("uniform", n, DIMENSIONS);
        const double step = lengths[k] * pow(n, -1.0 / DIMENSIONS);
        struct projection projection =
            projection_make(&workload->points);
        move_points(workload, step);
        const double shifts =
            (double)projection_update(&projection) / n / DIMENSIONS;
        row("moves_%g\t%g\t%u\t%.4g\t%.4g", 10000 * lengths[k],
            lengths[k], n, n * step / 3, shifts);
        projection_free(&projection);
        workload_free(workload);
    }
}

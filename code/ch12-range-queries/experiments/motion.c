// Points that move, a step of a given length at a time: the time to
// bring each structure in line with them, beside that to build it, and
// what a query costs after ten steps.
//
//     motion [POINTS [TRIALS]]
#include "ch12-range-queries/experiments/query_workload.h"
#include <math.h>

enum { STEPS = 10, HELD = 100 };

// In units of the mean spacing of the points.
static const double lengths[] = {0, 0.001, 0.01, 0.1, 1, 10};

static void print_motion(const struct structure *s, uint32_t n,
                         double length, int trials)
{
    struct query_workload *workload = workload_of("uniform", n, 3);
    const double spacing = pow(n, -1.0 / 3);
    double update[STEPS];
    int64_t start = clock_ns();
    void *built = s->build(&workload->points, 1);
    const double build_ns = clock_ns() - start;
    for (int step = 0; step < STEPS; step++) {
        move_points(workload, length * spacing);
        start = clock_ns();
        built = structure_update(s, built, &workload->points, 1);
        update[step] = clock_ns() - start;
    }
    const struct summary summary = summarize(update, STEPS);
    boxes_anywhere(workload, pow((double)HELD / n, 1.0 / 3));
    const struct cost cost = ask_boxes(workload, s, built, trials);
    row_begin("%s_moved_%g\t%s\t%g\t%u\t%.4g", s->name, 1000 * length,
              s->name, length, n, build_ns / n);
    row_times(&summary, n);
    row_cells("\t%.5g", cost.tested);
    row_times(&cost.ns, 1);
    row_end();
    s->discard(built);
    workload_free(workload);
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    const uint32_t n = parameter(&e, "POINTS", 30000, 1000, MANY);
    const int trials = parameter(&e, "TRIALS", 3, 1, MAX_TRIALS);
    print_header(&e,
                 "name structure length n build update:3 tested ns:3");
    for (int row = 1; row < structure_count; row++) // after the scan
        for (int k = 0; k < COUNT_OF(lengths); k++)
            print_motion(&structures[row], n, lengths[k], trials);
}

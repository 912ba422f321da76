// The triangular loop under each guard, on one thread and on all
// processors.
//
//     guards [POINTS [TRIALS]]
#include "ch03-half-pairs/experiments/compare.h"
#include "ch03-half-pairs/guarded.h"
#include "ch03-half-pairs/private.h"
#include "ch03-half-pairs/triangle.h"
#include "common/experiment.h"
#include <omp.h>

static const struct version guards[] = {
    {"none", triangle, triangle}, // knows nothing of threads
    {"queue", triangle_queue, triangle_queue},
    {"critical", triangle_critical, triangle_critical},
    {"atomic", triangle_atomic, triangle_atomic},
    {"reduction", triangle_reduction, triangle_reduction},
};
enum { GUARDS = sizeof guards / sizeof *guards };

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 1000, 2, MANY);
    int trials = parameter(&e, "TRIALS", 3, 1, MANY);
    struct points points = uniform_question(STANDARD, n, 1).points;
    struct times times[GUARDS];
    compare(points, STANDARD, trials, guards, GUARDS, times);
    columns(&e, "name n threads one_ns:3 all_ns:3");
    const double pairs = n * (n - 1.0);
    for (int g = 0; g < GUARDS; g++) {
        row_begin("%s\t%u\t%d", guards[g].name, n, omp_get_num_procs());
        row_times(&times[g].serial, pairs);
        row_times(&times[g].parallel, pairs);
        row_end();
    }
    points_free(&points);
    return 0;
}

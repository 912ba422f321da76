//> Time the guards
// The triangular loop under each guard, on one thread and on all
// processors.
//
//     guards [POINTS [TRIALS]]
#include "ch02-all-pairs/timing.h"
#include "ch03-half-pairs/compare.h"
#include "ch03-half-pairs/guarded.h"
#include "ch03-half-pairs/private.h"
#include "ch03-half-pairs/triangle.h"
#include "common/argument.h"
#include "common/fail.h"
#include "common/report.h"
#include <omp.h>
#include <stdio.h>

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
    fail_as("guards");
    uint32_t n = argument(argc, argv, 1, "POINTS", 1000, 2, MANY);
    int trials = argument(argc, argv, 2, "TRIALS", 3, 1, MANY);
    struct points points = uniform_question(STANDARD, n, 1).points;
    struct times times[GUARDS];
    compare(points, STANDARD, trials, guards, GUARDS, times);
    report_provenance(stdout);
    puts("name\tn\tthreads\tone_ns\tone_ns_q1\tone_ns_q3"
         "\tall_ns\tall_ns_q1\tall_ns_q3");
    const double pairs = n * (n - 1.0);
    for (int g = 0; g < GUARDS; g++) {
        printf("%s\t%u\t%d", guards[g].name, n, omp_get_num_procs());
        print_summary(&times[g].serial, pairs);
        print_summary(&times[g].parallel, pairs);
        puts("");
    }
    points_free(&points);
    return 0;
}
//<

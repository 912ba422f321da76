//> Time the coursework's table
// Both geometries, all pairs and half the pairs, one thread and all
// processors; and beside them the last versions of both chapters.
//
//     speed [POINTS [TRIALS]]
#include "ch02-all-pairs/naive.h"
#include "ch02-all-pairs/tiles.h"
#include "ch02-all-pairs/timing.h"
#include "ch03-half-pairs/compare.h"
#include "ch03-half-pairs/guarded.h"
#include "ch03-half-pairs/private.h"
#include "ch03-half-pairs/triangle.h"
#include "ch03-half-pairs/triangle_tiles.h"
#include "common/argument.h"
#include "common/fail.h"
#include "common/report.h"
#include <omp.h>
#include <stdio.h>

//> Pair serial with parallel versions
static const struct version versions[] = {
    {"naive", naive, naive},
    {"triangle", triangle, triangle_critical},
    {"private", triangle, triangle_reduction},
    {"tiles", tiles, tiles},
    {"half_tiles", triangle_tiles, triangle_tiles},
};
enum { VERSIONS = sizeof versions / sizeof *versions };
//<

static void print_geometry(const char *name, enum geometry geometry,
                           struct points points, int trials)
{
    struct times times[VERSIONS];
    const double pairs = points.n * (points.n - 1.0);
    compare(points, geometry, trials, versions, VERSIONS, times);
    for (int v = 0; v < VERSIONS; v++) {
        printf("%s_%s\t%u\t%d", name, versions[v].name, points.n,
               omp_get_num_procs());
        print_summary(&times[v].serial, pairs);
        print_summary(&times[v].parallel, pairs);
        puts("");
    }
}

int main(int argc, char **argv)
{
    fail_as("speed");
    uint32_t n = argument(argc, argv, 1, "POINTS", 3000, 2, MANY);
    int trials = argument(argc, argv, 2, "TRIALS", 3, 1, MANY);
    struct points points = uniform_question(STANDARD, n, 1).points;
    report_provenance(stdout);
    puts("name\tn\tthreads\tserial_ns\tserial_ns_q1\tserial_ns_q3"
         "\tparallel_ns\tparallel_ns_q1\tparallel_ns_q3");
    print_geometry("standard", STANDARD, points, trials);
    print_geometry("wraparound", WRAPAROUND, points, trials);
    points_free(&points);
    return 0;
}
//<

// Both geometries, all pairs and half the pairs, one thread and all
// processors; and beside them the last versions of both chapters.
//
//     speed [POINTS [TRIALS]]
#include "ch02-all-pairs/naive.h"
#include "ch02-all-pairs/tiles.h"
#include "ch03-half-pairs/experiments/compare.h"
#include "ch03-half-pairs/guarded.h"
#include "ch03-half-pairs/private.h"
#include "ch03-half-pairs/triangle.h"
#include "ch03-half-pairs/triangle_tiles.h"
#include "common/experiment.h"
#include <omp.h>

static const struct version versions[] = {
    {"naive", naive, naive},
    {"triangle", triangle, triangle_critical},
    {"private", triangle, triangle_reduction},
    {"tiles", tiles, tiles},
    {"half_tiles", triangle_tiles, triangle_tiles},
};
enum { VERSIONS = sizeof versions / sizeof *versions };

static void print_geometry(const char *name, enum geometry geometry,
                           struct points points, int trials)
{
    struct times times[VERSIONS];
    const double pairs = points.n * (points.n - 1.0);
    compare(points, geometry, trials, versions, VERSIONS, times);
    for (int v = 0; v < VERSIONS; v++) {
        row_begin("%s_%s\t%u\t%d", name, versions[v].name, points.n,
                  omp_get_num_procs());
        row_times(&times[v].serial, pairs);
        row_times(&times[v].parallel, pairs);
        row_end();
    }
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 3000, 2, MANY);
    int trials = parameter(&e, "TRIALS", 3, 1, MANY);
    struct points points = uniform_question(STANDARD, n, 1).points;
    columns(&e, "name n threads serial_ns:3 parallel_ns:3");
    print_geometry("standard", STANDARD, points, trials);
    print_geometry("wraparound", WRAPAROUND, points, trials);
    points_free(&points);
    return 0;
}

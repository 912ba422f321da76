// Both geometries, all pairs and half the pairs, one thread and all
// processors; and beside them the last versions of both chapters.
//     speed [POINTS [TRIALS]]
#include "ch02-all-pairs/naive.h"
#include "ch02-all-pairs/tiles.h"
#include "ch03-half-pairs/experiments/compare.h"
#include "ch03-half-pairs/guarded.h"
#include "ch03-half-pairs/private.h"
#include "ch03-half-pairs/triangle.h"
#include "ch03-half-pairs/triangle_tiles.h"

static const struct version versions[] = {
    {"naive", naive, naive},
    {"triangle", triangle, triangle_critical},
    {"private", triangle, triangle_reduction},
    {"tiles", tiles, tiles},
    {"half_tiles", triangle_tiles, triangle_tiles},
    {"critical", triangle_critical, triangle_critical},
};

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 3000, 2, MANY);
    int trials = parameter(&e, "TRIALS", 3, 1, MANY);
    struct question question = uniform_question(STANDARD, n, 1);
    print_header(&e, "name n threads serial_ns:3 parallel_ns:3");
    compare(&question, trials, versions, COUNT_OF(versions),
            "standard_");
    question.space.geometry = WRAPAROUND;
    compare(&question, trials, versions, COUNT_OF(versions),
            "wraparound_");
}

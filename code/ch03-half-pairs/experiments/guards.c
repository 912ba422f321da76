// The triangular loop under each guard, on one thread and on all
// processors.
//     guards [POINTS [TRIALS]]
#include "ch03-half-pairs/experiments/compare.h"
#include "ch03-half-pairs/guarded.h"
#include "ch03-half-pairs/private.h"
#include "ch03-half-pairs/triangle.h"

static const struct version guards[] = {
    {"none", triangle, triangle}, // knows nothing of threads
    {"queue", triangle_locked, triangle_locked},
    {"critical", triangle_critical, triangle_critical},
    {"atomic", triangle_atomic, triangle_atomic},
    {"reduction", triangle_reduction, triangle_reduction},
};

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 1000, 2, MANY);
    int trials = parameter(&e, "TRIALS", 3, 1, MANY);
    struct question question = uniform_question(STANDARD, n, 1);
    print_header(&e, "name n threads one_ns:3 all_ns:3");
    compare(&question, trials, guards, COUNT_OF(guards), "");
}

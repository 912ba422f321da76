//> Race all pairs against the cells
// The best program of chapter 2 and those of this chapter, both
// geometries, one thread, in turn; sorting included.
//
//     race [POINTS [TRIALS]]
#include "ch02-all-pairs/tiles.h"
#include "ch02-all-pairs/timing.h"
#include "ch04-cell-sort/point_by_point.h"
#include "ch04-cell-sort/together.h"
#include "common/argument.h"
#include "common/fail.h"
#include "common/report.h"
#include <stdio.h>

static const struct {
    const char *name;
    search_function *search;
} runners[] = {
    {"all_pairs", tiles},          {"by_lists", cells_lists},
    {"by_indices", cells_indices}, {"by_sorted", cells_sorted},
    {"by_cells", cells_together},
};
enum { RUNNERS = sizeof runners / sizeof *runners };

int main(int argc, char **argv)
{
    fail_as("race");
    uint32_t n = argument(argc, argv, 1, "POINTS", 20000, 2, MANY);
    int trials = argument(argc, argv, 2, "TRIALS", 3, 1, MANY);
    struct answers answers = answers_allocate(n);
    struct search searches[2][RUNNERS];
    struct trial versions[2][RUNNERS];
    struct question question = uniform_question(STANDARD, n, 1);
    for (int g = 0; g < 2; g++) {
        question.space.geometry = g ? WRAPAROUND : STANDARD;
        for (int r = 0; r < RUNNERS; r++) {
            searches[g][r] =
                (struct search){runners[r].search, question, &answers};
            versions[g][r] = (struct trial){.work = run_search,
                                            .context = &searches[g][r]};
        }
    }
    time_in_turn(trials, versions[0], 2 * RUNNERS);
    report_provenance(stdout);
    puts("name\tn\tstandard\tstandard_q1\tstandard_q3"
         "\twraparound\twraparound_q1\twraparound_q3");
    for (int r = 0; r < RUNNERS; r++) {
        printf("%s\t%u", runners[r].name, n);
        for (int g = 0; g < 2; g++)
            print_summary(&versions[g][r].summary, n);
        puts("");
    }
    answers_free(&answers);
    points_free(&question.points);
    return 0;
}
//<

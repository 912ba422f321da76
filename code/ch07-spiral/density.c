//> Vary the points in a cell
// Distances and cells a point, counted and expected, and the time of
// sort and search, with the points asking in the order of the cells.
//
//     density [POINTS [TRIALS]]
#include "ch02-all-pairs/timing.h"
#include "ch07-spiral/census.h"
#include "ch07-spiral/expected.h"
#include "ch07-spiral/spiral.h"
#include "common/argument.h"
#include "common/fail.h"
#include "common/report.h"
#include <omp.h>
#include <stdio.h>

struct setting {
    const char *name;
    double c;
};

static const struct setting settings[] = {
    {"third", 1.0 / 3}, {"half", 0.5},         {"two_thirds", 2.0 / 3},
    {"one", 1},         {"three_halves", 1.5}, {"two", 2},
    {"three", 3},       {"four", 4},           {"six", 6},
    {"eight", 8},
};
enum { SETTINGS = sizeof settings / sizeof *settings };

//> Time a search with c points in a cell
struct timed {
    const struct question *question;
    struct answers *answers;
    double c;
};

static void sort_and_search(void *context)
{
    struct timed *timed = context;
    struct grid grid = grid_fit(timed->question, timed->c);
    struct cells cells = cells_sort(&grid, timed->question->points);
    search_spiral(timed->question, &grid, &cells, cells.point,
                  timed->answers);
    cells_free(&cells);
    grid_free(&grid);
}
//<

int main(int argc, char **argv)
{
    fail_as("density");
    uint32_t n = argument(argc, argv, 1, "POINTS", 100000, 2, MANY);
    int trials = argument(argc, argv, 2, "TRIALS", 3, 1, MANY);
    struct question question = uniform_question(STANDARD, n, 1);
    struct answers answers = answers_allocate(n);
    struct timed timed[SETTINGS];
    struct trial trial[SETTINGS];
    for (int k = 0; k < SETTINGS; k++) {
        timed[k] = (struct timed){&question, &answers, settings[k].c};
        trial[k] = (struct trial){.work = sort_and_search,
                                  .context = &timed[k]};
    }
    time_in_turn(trials, trial, SETTINGS);
    report_provenance(stdout);
    puts("name\tn\tc\tdistances\tcells\texpected\texpected_cells"
         "\tns\tns_q1\tns_q3");
    question.threads = omp_get_num_procs();
    for (int k = 0; k < SETTINGS; k++) {
        struct census census = take_census(&question, settings[k].c);
        struct expected expected = expected_spiral(census.per_cell);
        printf("%s\t%u\t%.6g\t%.6g\t%.6g\t%.6g\t%.6g", settings[k].name,
               n, census.per_cell, census.distances, census.cells,
               expected.distances, expected.cells);
        print_summary(&trial[k].summary, n);
        puts("");
    }
    answers_free(&answers);
    points_free(&question.points);
    return 0;
}
//<

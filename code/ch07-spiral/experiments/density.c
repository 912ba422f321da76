// Distances and cells a point, counted and expected, and the time of
// sort and search, with the queries in the order of the cells.
//     density [POINTS [TRIALS]]
#include "ch07-spiral/experiments/census.h"
#include "ch07-spiral/experiments/expected.h"
#include "ch07-spiral/spiral.h"
#include "common/experiment.h"

static const struct {
    const char *name;
    double c;
} settings[] = {
    {"third", 1.0 / 3}, {"half", 0.5},         {"two_thirds", 2.0 / 3},
    {"one", 1},         {"three_halves", 1.5}, {"two", 2},
    {"three", 3},       {"four", 4},           {"six", 6},
    {"eight", 8},
};
enum { SETTINGS = COUNT_OF(settings) };

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

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 100000, 2, MANY);
    int trials = parameter(&e, "TRIALS", 3, 1, MANY);
    struct question question = uniform_question(STANDARD, n, 1);
    struct answers *answers = new_answers(n, BOTH);
    struct timed timed[SETTINGS];
    struct trial trial[SETTINGS];
    for (int k = 0; k < SETTINGS; k++) {
        timed[k] = (struct timed){&question, answers, settings[k].c};
        trial[k] = (struct trial){sort_and_search, &timed[k]};
    }
    time_in_turn(trials, trial, SETTINGS);
    print_header(
        &e, "name n c distances cells expected expected_cells ns:3");
    question.threads = omp_get_num_procs();
    for (int k = 0; k < SETTINGS; k++) {
        struct census census = take_census(&question, settings[k].c);
        struct expected expected = expected_spiral(census.per_cell);
        row_of_times(
            &trial[k], 1, n, "%s\t%u\t%.6g\t%.6g\t%.6g\t%.6g\t%.6g",
            settings[k].name, n, census.per_cell, census.distances,
            census.cells, expected.distances, expected.cells);
    }
}

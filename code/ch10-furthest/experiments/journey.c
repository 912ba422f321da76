// Nearest and furthest neighbors by the programs of all chapters in one
// run, from the coursework's loop on: both geometries, one thread and
// all processors, nanoseconds a point. Those that would take minutes
// get fewer points, and their time is scaled by the number of pairs.
//     journey [POINTS [FEWER [TRIALS]]]
#include "ch02-all-pairs/first.h"
#include "common/experiment.h"

// The first compare all pairs of fewer points, and those before QUICK
// run once. Each in both geometries, on one thread and on all.
enum { SLOW = 4, QUICK = 6, STAGES = 17, TIMES = 4 };

static const char *const stages[STAGES] = {
    "first",          "naive",
    "triangle",       "triangle-reduction",
    "tiles",          "triangle-tiles",
    "cells-lists",    "cells-indices",
    "cells-sorted",   "cells",
    "cells-threads",  "spiral",
    "vector-spiral",  "row-spans",
    "furthest-cells", "furthest-hull",
    "near-and-far"};

// On one thread, whatever the question allows. It is not in the table
// of algorithms.
static void first_search_all(const struct question *question,
                             struct answers *answers)
{
    first_rows(question, answers, 0, question->points.n);
}

static const struct algorithm coursework = {"first",
                                            2,
                                            STANDARD | WRAPAROUND,
                                            NEAREST | FURTHEST,
                                            "n^2",
                                            "the distance is passed",
                                            first_search_all};

static const struct algorithm *algorithm_of(int stage)
{
    return stage == 0 ? &coursework : find_algorithm(stages[stage]);
}

// Time k of a stage is in geometry k / 2, on all processors if k is
// odd. Not all stages know both geometries, or threads.
static bool is_there(int stage, int k)
{
    return algorithm_of(stage)->geometries &
               (k / 2 ? WRAPAROUND : STANDARD) &&
           !(stage == 0 && k % 2);
}

// The trials of a stage, of those that are there; returns how many.
static int list_trials(int stage, struct question question,
                       struct answers *answers, struct trial *trials)
{
    int count = 0;
    for (int k = 0; k < TIMES; k++) {
        question.space.geometry = k / 2 ? WRAPAROUND : STANDARD;
        question.threads = k % 2 ? omp_get_num_procs() : 1;
        if (is_there(stage, k))
            trials[count++] = search_trial(algorithm_of(stage)->run,
                                           &question, answers);
    }
    return count;
}

// Nanoseconds for each of n points, of which fewer were timed: then
// each would have met n / fewer times as many others.
static void print_stage(int stage, const struct trial *trials,
                        uint32_t n, uint32_t fewer)
{
    const struct algorithm *algorithm = algorithm_of(stage);
    row_begin("%s\t%d\t%s\t%u\t%d", stages[stage], algorithm->chapter,
              algorithm->answers == NEAREST    ? "nearest"
              : algorithm->answers == FURTHEST ? "furthest"
                                               : "both",
              fewer, omp_get_num_procs());
    for (int k = 0; k < TIMES; k++)
        if (is_there(stage, k))
            row_times(&trials++->summary, (double)fewer * fewer / n);
        else
            row_cells("\t-\t-\t-");
    row_end();
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 20000, 2, MANY);
    uint32_t fewer = parameter(&e, "FEWER", 4000, 2, n);
    int count = parameter(&e, "TRIALS", 3, 1, MANY);
    struct workspace workspace = {0};
    struct question all = uniform_question(STANDARD, n, 1);
    struct question some = uniform_question(STANDARD, fewer, 1);
    all.workspace = some.workspace = &workspace;
    struct trial trials[STAGES * TIMES];
    int first[STAGES + 1] = {0}; // trial of each stage
    for (int s = 0; s < STAGES; s++)
        first[s + 1] =
            first[s] +
            list_trials(s, s < SLOW ? some : all,
                        new_answers(n, algorithm_of(s)->answers),
                        trials + first[s]);
    time_in_turn(1, trials, first[SLOW]);
    time_in_turn(1, trials + first[SLOW], first[QUICK] - first[SLOW]);
    // What takes milliseconds is timed again and again, with memory and
    // caches as it leaves them.
    for (int k = first[QUICK]; k < first[STAGES]; k++)
        time_in_turn(count, &trials[k], 1);
    print_header(&e, "name chapter answers n threads standard:3 "
                     "standard_all:3 wraparound:3 wraparound_all:3");
    for (int s = 0; s < STAGES; s++)
        print_stage(s, trials + first[s], n, s < SLOW ? fewer : n);
}

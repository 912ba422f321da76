// Nearest and furthest neighbors by the programs of all chapters in one
// run, from the coursework's loop on: both geometries, one thread and
// all processors, nanoseconds a point. Those that would take minutes
// get fewer points, and their time is scaled by the number of pairs.
//
//     journey [POINTS [FEWER [TRIALS]]]
#include "algorithms.h"
#include "ch02-all-pairs/first.h"
#include "common/experiment.h"
#include "common/workspace.h"
#include <omp.h>
#include <stdbool.h>
#include <string.h>

enum { GEOMETRIES = 2, THREADS = 2, TIMES = GEOMETRIES * THREADS };

// How long a stage may take: SLOW ones compare all of fewer points,
// LONG ones run once.
enum pace { SLOW, LONG, FAST };

static const struct stage {
    const char *name;
    enum pace pace;
} stages[] = {
    {"first", SLOW},          {"naive", SLOW},
    {"triangle", SLOW},       {"triangle-reduction", SLOW},
    {"tiles", LONG},          {"triangle-tiles", LONG},
    {"cells-lists", FAST},    {"cells-indices", FAST},
    {"cells-sorted", FAST},   {"cells", FAST},
    {"cells-threads", FAST},  {"spiral", FAST},
    {"vector-spiral", FAST},  {"row-spans", FAST},
    {"furthest-cells", FAST}, {"furthest-hull", FAST},
    {"near-and-far", FAST},
};
enum { STAGES = sizeof stages / sizeof *stages };

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

static const struct algorithm *stage_algorithm(const char *name)
{
    return strcmp(name, coursework.name) == 0 ? &coursework
                                              : find_algorithm(name);
}

struct times {
    struct search search[TIMES];
    struct trial trial[TIMES];
    bool there[TIMES];
};

static void prepare_stage(struct times *times,
                          const struct algorithm *algorithm,
                          struct question question,
                          struct answers *answers)
{
    for (int k = 0; k < TIMES; k++) {
        bool all = k % THREADS;
        question.space.geometry = k / THREADS ? WRAPAROUND : STANDARD;
        question.threads = all ? omp_get_num_procs() : 1;
        times->search[k] =
            (struct search){algorithm->run, question, answers};
        times->trial[k] = (struct trial){.work = run_search,
                                         .context = &times->search[k]};
        times->there[k] =
            algorithm->geometries & question.space.geometry &&
            !(all && algorithm == &coursework);
    }
}

// But what takes milliseconds is timed again and again, with memory and
// caches as it leaves them.
static void time_fast(int trials, struct times *times)
{
    for (int s = 0; s < STAGES; s++)
        for (int k = 0; k < TIMES; k++)
            if (stages[s].pace == FAST && times[s].there[k])
                time_in_turn(trials, &times[s].trial[k], 1);
}

static void time_pace(enum pace pace, struct times *times)
{
    struct trial turn[STAGES * TIMES];
    int count = 0;
    for (int s = 0; s < STAGES; s++)
        for (int k = 0; k < TIMES; k++)
            if (stages[s].pace == pace && times[s].there[k])
                turn[count++] = times[s].trial[k];
    time_in_turn(1, turn, count);
    count = 0;
    for (int s = 0; s < STAGES; s++)
        for (int k = 0; k < TIMES; k++)
            if (stages[s].pace == pace && times[s].there[k])
                times[s].trial[k] = turn[count++];
}

// Nanoseconds for each of n points, of which fewer were timed: then
// each would have met n / fewer times as many others.
static void print_stage(const struct algorithm *algorithm,
                        const struct times *times, uint32_t n,
                        uint32_t fewer)
{
    row_begin("%s\t%d\t%s\t%u\t%d", algorithm->name, algorithm->chapter,
              algorithm->answers == NEAREST    ? "nearest"
              : algorithm->answers == FURTHEST ? "furthest"
                                               : "both",
              fewer, omp_get_num_procs());
    for (int k = 0; k < TIMES; k++)
        if (times->there[k])
            row_times(&times->trial[k].summary,
                      (double)fewer * fewer / n);
        else
            row_cells("\t-\t-\t-");
    row_end();
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 20000, 2, MANY);
    uint32_t fewer = parameter(&e, "FEWER", 4000, 2, n);
    int trials = parameter(&e, "TRIALS", 3, 1, MANY);
    struct workspace workspace = {0};
    struct question all = uniform_question(STANDARD, n, 1);
    struct question some = uniform_question(STANDARD, fewer, 1);
    all.workspace = some.workspace = &workspace;
    struct answers answers[STAGES];
    struct times times[STAGES];
    for (int s = 0; s < STAGES; s++) {
        const struct algorithm *algorithm =
            stage_algorithm(stages[s].name);
        answers[s] = answers_for(n, algorithm->answers);
        prepare_stage(&times[s], algorithm,
                      stages[s].pace == SLOW ? some : all, &answers[s]);
    }
    time_pace(SLOW, times);
    time_pace(LONG, times);
    time_fast(trials, times);
    columns(&e, "name chapter answers n threads standard:3 "
                "standard_all:3 wraparound:3 wraparound_all:3");
    for (int s = 0; s < STAGES; s++) {
        bool slow = stages[s].pace == SLOW;
        print_stage(stage_algorithm(stages[s].name), &times[s], n,
                    slow ? fewer : n);
        answers_free(&answers[s]);
    }
    workspace_free(&workspace);
    points_free(&some.points);
    points_free(&all.points);
    return 0;
}

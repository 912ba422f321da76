// The best program of chapter 2 and those of this chapter, both
// geometries, one thread, in turn; sorting included.
//
//     race [POINTS [TRIALS]]
#include "ch02-all-pairs/tiles.h"
#include "ch04-cell-sort/batches.h"
#include "ch04-cell-sort/point_by_point.h"
#include "common/experiment.h"

static void queries(const struct question *question,
                    struct answers *answers)
{
    queries_rows(question, answers, 0, question->points.n);
}

static const struct {
    const char *name;
    search_function *search;
} runners[] = {
    {"all_pairs", tiles},        {"by_queries", queries},
    {"by_lists", cells_lists},   {"by_indices", cells_indices},
    {"by_sorted", cells_sorted}, {"by_cells", cells_batched},
};
enum { RUNNERS = sizeof runners / sizeof *runners };

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 20000, 2, MANY);
    int trials = parameter(&e, "TRIALS", 3, 1, MANY);
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
    columns(&e, "name n standard:3 wraparound:3");
    for (int r = 0; r < RUNNERS; r++) {
        row_begin("%s\t%u", runners[r].name, n);
        for (int g = 0; g < 2; g++)
            row_times(&versions[g][r].summary, n);
        row_end();
    }
    answers_free(&answers);
    points_free(&question.points);
    return 0;
}

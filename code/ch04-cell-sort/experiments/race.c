// The best program of chapter 2 and those of this chapter, both
// geometries, one thread, in turn; sorting included.
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
    {"tiles", tiles},
    {"queries", queries},
    {"cells_lists", cells_lists},
    {"cells_indices", cells_indices},
    {"cells_sorted", cells_sorted},
    {"cells", cells_batched},
};

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 20000, 2, MANY);
    int trials = parameter(&e, "TRIALS", 3, 1, MANY);
    struct question standard = uniform_question(STANDARD, n, 1);
    struct question wraparound = standard;
    wraparound.space.geometry = WRAPAROUND;
    struct answers *answers = new_answers(n, BOTH);
    struct trial versions[2 * COUNT_OF(runners)];
    for (int r = 0; r < COUNT_OF(runners); r++) {
        search_function *search = runners[r].search;
        versions[2 * r] = search_trial(search, &standard, answers);
        versions[2 * r + 1] =
            search_trial(search, &wraparound, answers);
    }
    time_in_turn(trials, versions, 2 * COUNT_OF(runners));
    print_header(&e, "name n standard:3 wraparound:3");
    for (int r = 0; r < COUNT_OF(runners); r++)
        row_of_times(&versions[2 * r], 2, n, "%s\t%u", runners[r].name,
                     n);
}

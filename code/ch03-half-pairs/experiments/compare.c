// Times whole algorithms in turn and prints them. All versions write
// into the same answers; that these are right is for the tests.
#include "ch03-half-pairs/experiments/compare.h"

void compare(const struct question *question, int trials,
             const struct version *versions, int count,
             const char *prefix)
{
    const uint32_t n = question->points.n;
    struct question one = *question, all = *question;
    all.threads = omp_get_num_procs();
    struct answers *answers = new_answers(n, BOTH);
    struct trial *turns = take(2 * count, sizeof *turns);
    for (int v = 0; v < count; v++) {
        turns[2 * v] = search_trial(versions[v].serial, &one, answers);
        turns[2 * v + 1] =
            search_trial(versions[v].parallel, &all, answers);
    }
    time_in_turn(trials, turns, 2 * count);
    for (int v = 0; v < count; v++)
        row_of_times(&turns[2 * v], 2, n * (n - 1.0), "%s%s\t%u\t%d",
                     prefix, versions[v].name, n, all.threads);
}

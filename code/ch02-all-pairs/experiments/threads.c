// The plain search and the last version on 1, 2, 4, ... threads, up to
// as many as there are processors.
//     threads [POINTS [TRIALS]]
#include "ch02-all-pairs/naive.h"
#include "ch02-all-pairs/tiles.h"
#include "common/experiment.h"

enum { MOST = 32 };

// 1, 2, 4, ..., and all processors.
static int thread_counts(int threads[MOST])
{
    int count = 0, all = omp_get_num_procs();
    for (int t = 1; t < all; t *= 2)
        threads[count++] = t;
    threads[count++] = all;
    return count;
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 8192, 2, MANY);
    int trials = parameter(&e, "TRIALS", 5, 1, MANY);
    struct question question = uniform_question(STANDARD, n, 1);
    struct answers *answers = new_answers(n, BOTH);
    struct trial versions[2 * MOST];
    int threads[MOST], count = thread_counts(threads);
    for (int k = 0; k < count; k++) {
        question.threads = threads[k];
        versions[2 * k] = search_trial(naive, &question, answers);
        versions[2 * k + 1] = search_trial(tiles, &question, answers);
    }
    time_in_turn(trials, versions, 2 * count);
    print_header(&e, "name threads points naive_ns:3 tiles_ns:3");
    for (int k = 0; k < count; k++) {
        char name[20];
        sprintf(name, "threads_%d", threads[k]);
        row_of_times(&versions[2 * k], 2, 1, "%s\t%d\t%u",
                     k == 0           ? "one"
                     : k == count - 1 ? "all"
                                      : name,
                     threads[k], n);
    }
}

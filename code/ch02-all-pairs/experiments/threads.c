// The plain search and the last version on 1, 2, 4, ... threads, up to
// as many as there are processors.
//
//     threads [POINTS [TRIALS]]
#include "ch02-all-pairs/naive.h"
#include "ch02-all-pairs/tiles.h"
#include "common/experiment.h"
#include <omp.h>

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 8192, 2, MANY);
    int trials = parameter(&e, "TRIALS", 5, 1, MANY);
    struct question question = uniform_question(STANDARD, n, 1);
    struct answers answers = answers_allocate(n);

    enum { MOST = 32 };
    int threads[MOST], counts = 0, all = omp_get_num_procs();
    for (int t = 1; t < all; t *= 2)
        threads[counts++] = t;
    threads[counts++] = all;

    struct search searches[2 * MOST];
    struct trial versions[2 * MOST];
    for (int v = 0; v < 2 * counts; v++) {
        searches[v] =
            (struct search){v % 2 ? tiles : naive, question, &answers};
        searches[v].question.threads = threads[v / 2];
        versions[v] =
            (struct trial){.work = run_search, .context = &searches[v]};
    }
    time_in_turn(trials, versions, 2 * counts);
    columns(&e, "name threads points naive_ns:3 tiles_ns:3");
    for (int c = 0; c < counts; c++) {
        if (c == 0)
            row_begin("one");
        else if (c == counts - 1)
            row_begin("all");
        else
            row_begin("threads_%d", threads[c]);
        row_cells("\t%d\t%u", threads[c], n);
        row_times(&versions[2 * c].summary, 1);
        row_times(&versions[2 * c + 1].summary, 1);
        row_end();
    }
    answers_free(&answers);
    points_free(&question.points);
    return 0;
}

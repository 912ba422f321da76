//> Time more and more threads
// The plain search and the last version on 1, 2, 4, ... threads, up to
// as many as there are processors.
//
//     threads [POINTS [TRIALS]]
#include "ch02-all-pairs/naive.h"
#include "ch02-all-pairs/tiles.h"
#include "ch02-all-pairs/timing.h"
#include "common/argument.h"
#include "common/fail.h"
#include "common/report.h"
#include <omp.h>
#include <stdio.h>

int main(int argc, char **argv)
{
    fail_as("threads");
    uint32_t n = argument(argc, argv, 1, "POINTS", 8192, 2, MANY);
    int trials = argument(argc, argv, 2, "TRIALS", 5, 1, MANY);
    struct question question = uniform_question(STANDARD, n, 1);
    struct answers answers = answers_allocate(n);

    //> Double the threads up to the number of processors
    enum { MOST = 32 };
    int threads[MOST], counts = 0, all = omp_get_num_procs();
    for (int t = 1; t < all; t *= 2)
        threads[counts++] = t;
    threads[counts++] = all;
    //<

    //> Time both searches with each
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
    //<
    report_provenance(stdout);
    puts("name\tthreads\tpoints\tnaive_ns\tnaive_ns_q1\tnaive_ns_q3"
         "\ttiles_ns\ttiles_ns_q1\ttiles_ns_q3");
    for (int c = 0; c < counts; c++) {
        if (c == 0)
            printf("one");
        else if (c == counts - 1)
            printf("all");
        else
            printf("threads_%d", threads[c]);
        printf("\t%d\t%u", threads[c], n);
        print_summary(&versions[2 * c].summary, 1);
        print_summary(&versions[2 * c + 1].summary, 1);
        puts("");
    }
    answers_free(&answers);
    points_free(&question.points);
    return 0;
}
//<

//> Time more and more points
// One point that meets eight candidates at once, against eight points
// that meet one: how the time of a pair depends on where the points
// fit, in the caches or beyond.
//
//     sizes [MOST [PAIRS [TRIALS]]]
#include "ch02-all-pairs/ladder.h"
#include "ch02-all-pairs/tiles.h"
#include "ch02-all-pairs/timing.h"
#include "common/argument.h"
#include "common/fail.h"
#include "common/report.h"
#include <stdio.h>

int main(int argc, char **argv)
{
    fail_as("sizes");
    uint32_t most = argument(argc, argv, 1, "MOST", 1 << 17, 512, MANY);
    double pairs = argument(argc, argv, 2, "PAIRS", 8000000, 1, MANY);
    int trials = argument(argc, argv, 3, "TRIALS", 5, 1, MANY);

    report_provenance(stdout);
    puts("name\tn\tkilobytes\tlanes_ns\tlanes_ns_q1\tlanes_ns_q3"
         "\tqueries_ns\tqueries_ns_q1\tqueries_ns_q3"
         "\ttiles_ns\ttiles_ns_q1\ttiles_ns_q3");
    for (uint64_t n = 512; n <= most; n *= 2) {
        //> Time the three at one size
        struct question question = uniform_question(STANDARD, n, 1);
        struct answers answers = answers_allocate(n);
        rows_function *ways[] = {lanes_rows, queries_rows, tiles_rows};
        uint32_t rows = (uint32_t)fmin(n, fmax(8, pairs / n)) / 8 * 8;
        struct run runs[3];
        struct trial versions[3];
        for (int v = 0; v < 3; v++) {
            runs[v] =
                (struct run){ways[v], &question, &answers, 0, rows};
            versions[v] =
                (struct trial){.work = run_rows, .context = &runs[v]};
        }
        time_in_turn(trials, versions, 3);
        //<
        printf("n_%u\t%u\t%u", (unsigned)n, (unsigned)n,
               (unsigned)(n * 2 * sizeof(double) / 1024));
        for (int v = 0; v < 3; v++)
            print_summary(&versions[v].summary, (double)rows * (n - 1));
        puts("");
        answers_free(&answers);
        points_free(&question.points);
    }
    return 0;
}
//<

//> Try blocks of all sizes
// The last version with blocks of 16, 32, ... candidates: small ones
// are noted too often, large ones take long to search again.
//
//     block-size [POINTS [ROWS [TRIALS]]]
#include "ch02-all-pairs/tiles.h"
#include "ch02-all-pairs/timing.h"
#include "common/argument.h"
#include "common/fail.h"
#include "common/report.h"
#include <stdio.h>

enum { SIZES = 9 };

struct blocked {
    struct run run;
    uint32_t block;
};

static void run_blocked(void *context)
{
    struct blocked *b = context;
    tiles_blocked_rows(b->run.question, b->run.answers, b->run.begin,
                       b->run.end, b->block);
}

int main(int argc, char **argv)
{
    fail_as("block-size");
    uint32_t n = argument(argc, argv, 1, "POINTS", 8192, 2, MANY);
    uint32_t rows = argument(argc, argv, 2, "ROWS", 512, 1, n);
    int trials = argument(argc, argv, 3, "TRIALS", 5, 1, MANY);
    struct question question = uniform_question(STANDARD, n, 1);
    struct answers answers = answers_allocate(n);

    //> Time all sizes in turn
    struct blocked sizes[SIZES];
    struct trial versions[SIZES];
    for (int s = 0; s < SIZES; s++) {
        sizes[s] = (struct blocked){
            {NULL, &question, &answers, 0, rows}, 16u << s};
        versions[s] =
            (struct trial){.work = run_blocked, .context = &sizes[s]};
    }
    time_in_turn(trials, versions, SIZES);
    //<
    report_provenance(stdout);
    puts("name\tblock\tns\tns_q1\tns_q3");
    for (int s = 0; s < SIZES; s++) {
        printf("block_%u\t%u", sizes[s].block, sizes[s].block);
        print_summary(&versions[s].summary, (double)rows * (n - 1));
        puts("");
    }
    answers_free(&answers);
    points_free(&question.points);
    return 0;
}
//<

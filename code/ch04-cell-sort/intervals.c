//> Time three ways to search a line
// What it costs to build each of three structures over numbers, and to
// ask it for an interval with few or many numbers in it.
//
//     intervals [MOST [TRIALS]]
#include "ch02-all-pairs/timing.h"
#include "ch04-cell-sort/line.h"
#include "common/argument.h"
#include "common/fail.h"
#include "common/random.h"
#include "common/report.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { QUESTIONS = 10000, WAYS = 3, FEW = 10, MANY_RESULTS = 1000 };

static const double per_bin = 2;

struct work {
    int way;
    uint32_t n, results;
    const double *numbers;
    double *sorted, *found, *from; // from: where the intervals begin
    struct bins bins;
    uint64_t count; // of results in all, so that nothing is left out
};

static void build(void *context)
{
    struct work *w = context;
    if (w->way == 1) {
        memcpy(w->sorted, w->numbers, w->n * sizeof *w->sorted);
        sort_numbers(w->sorted, w->n);
    } else if (w->way == 2) {
        bins_free(&w->bins);
        w->bins = bins_make(w->numbers, w->n, per_bin);
    }
}

static void ask(void *context)
{
    struct work *w = context;
    double width = (double)w->results / w->n;
    // A scan takes long enough for ten questions to be timed.
    int questions = w->way == 0 ? 10 : QUESTIONS;
    for (int q = 0; q < questions; q++) {
        double a = w->from[q] * (1 - width), b = a + width;
        w->count +=
            w->way == 0 ? scan_between(w->numbers, w->n, a, b, w->found)
            : w->way == 1
                ? sorted_between(w->sorted, w->n, a, b, w->found)
                : bins_between(&w->bins, a, b, w->found);
    }
}

static void print_row(uint32_t n, int trials)
{
    static const char *const ways[WAYS] = {"scan", "sorted", "bins"};
    struct random random = {1};
    double *numbers = allocate(n, sizeof *numbers);
    for (uint32_t i = 0; i < n; i++)
        numbers[i] = random_uniform(&random);
    static double from[QUESTIONS];
    for (int q = 0; q < QUESTIONS; q++)
        from[q] = random_uniform(&random);
    for (int way = 0; way < WAYS; way++) {
        struct work w = {.way = way,
                         .n = n,
                         .numbers = numbers,
                         .sorted = allocate(n, sizeof(double)),
                         .found = allocate(n, sizeof(double)),
                         .from = from};
        struct summary built = time_trials(trials, build, &w);
        printf("%s_%u\t%u", ways[way], n, n);
        print_summary(&built, n);
        for (w.results = FEW; w.results <= MANY_RESULTS;
             w.results *= MANY_RESULTS / FEW) {
            struct summary asked = time_trials(trials, ask, &w);
            print_summary(&asked, way == 0 ? 10 : QUESTIONS);
        }
        puts("");
        fflush(stdout);
        if (way == 2)
            bins_free(&w.bins);
        free(w.sorted);
        free(w.found);
    }
    free(numbers);
}

int main(int argc, char **argv)
{
    fail_as("intervals", NULL);
    uint32_t most =
        argument(argc, argv, 1, "MOST", 100000, 10000, MANY);
    int trials = argument(argc, argv, 2, "TRIALS", 3, 1, MANY);
    report_provenance(stdout);
    puts("name\tn\tbuild\tbuild_q1\tbuild_q3\tfew\tfew_q1\tfew_q3"
         "\tmany\tmany_q1\tmany_q3");
    for (uint64_t n = 10000; n <= most; n *= 10)
        print_row(n, trials);
    return 0;
}
//<

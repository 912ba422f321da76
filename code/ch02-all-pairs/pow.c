//> Time pow against a multiplication
// The coursework's search, with three ways to square. The experiment
// compiles this program twice, with and without optimization.
//
//     pow [POINTS [TRIALS]]
#include "ch02-all-pairs/first.h"
#include "ch02-all-pairs/timing.h"
#include "common/argument.h"
#include "common/fail.h"
#include "common/report.h"
#include <stdio.h>

#ifdef __OPTIMIZE__
#define LEVEL "optimized"
#else
#define LEVEL "plain"
#endif

//> Wrap each way to square into a search
static void multiply(const struct question *question,
                     struct answers *answers, uint32_t begin,
                     uint32_t end)
{
    first_search(question, answers, measure_standard, begin, end);
}

static void with_pow(const struct question *question,
                     struct answers *answers, uint32_t begin,
                     uint32_t end)
{
    first_search(question, answers, measure_pow, begin, end);
}

static void hidden(const struct question *question,
                   struct answers *answers, uint32_t begin,
                   uint32_t end)
{
    first_search(question, answers, measure_hidden, begin, end);
}
//<

int main(int argc, char **argv)
{
    fail_as("pow");
    uint32_t n = argument(argc, argv, 1, "POINTS", 1000, 2, MANY);
    int trials = argument(argc, argv, 2, "TRIALS", 5, 1, MANY);
    struct question question = uniform_question(STANDARD, n, 1);
    struct answers answers = answers_allocate(n);

    //> Time the three in turn
    struct run runs[] = {{multiply, &question, &answers, 0, n},
                         {with_pow, &question, &answers, 0, n},
                         {hidden, &question, &answers, 0, n}};
    const char *names[] = {"multiply", "pow", "hidden"};
    struct trial versions[3];
    for (int v = 0; v < 3; v++)
        versions[v] =
            (struct trial){.work = run_rows, .context = &runs[v]};
    time_in_turn(trials, versions, 3);
    //<
    report_provenance(stdout);
    puts("name\tns\tns_q1\tns_q3");
    for (int v = 0; v < 3; v++) {
        printf("%s_%s", names[v], LEVEL);
        print_summary(&versions[v].summary, (double)n * (n - 1));
        puts("");
    }
    answers_free(&answers);
    points_free(&question.points);
    return 0;
}
//<

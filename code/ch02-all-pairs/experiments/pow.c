// The coursework's search, with three ways to square. The experiment
// compiles this program twice, with and without optimization.
//     pow [POINTS [TRIALS]]
#include "ch02-all-pairs/experiments/rows.h"
#include "ch02-all-pairs/first.h"

#ifdef __OPTIMIZE__
#define LEVEL "optimized"
#else
#define LEVEL "plain"
#endif

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
    first_search(question, answers, measure_pow_variable, begin, end);
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 1000, 2, MANY);
    int trials = parameter(&e, "TRIALS", 5, 1, MANY);
    struct question question = uniform_question(STANDARD, n, 1);
    struct answers *answers = new_answers(n, BOTH);
    struct trial versions[] = {
        rows_trial(multiply, &question, answers, n),
        rows_trial(with_pow, &question, answers, n),
        rows_trial(hidden, &question, answers, n)};
    const char *names[] = {"multiply", "pow", "hidden"};
    time_in_turn(trials, versions, 3);
    print_header(&e, "name ns:3");
    for (int v = 0; v < 3; v++)
        row_of_times(&versions[v], 1, (double)n * (n - 1), "%s_%s",
                     names[v], LEVEL);
}

// What it costs to build each of three structures over numbers, and to
// query it for an interval with few or many numbers in it.
//     intervals [MOST [TRIALS]]
#include "ch04-cell-sort/line.h"
#include "common/experiment.h"

enum { SCAN, SORTED, BINS, WAYS };
enum { QUESTIONS = 10000, FEW = 10, MANY_RESULTS = 1000 };

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
    if (w->way == SORTED) {
        memcpy(w->sorted, w->numbers, w->n * sizeof *w->sorted);
        sort_numbers(w->sorted, w->n);
    } else if (w->way == BINS) {
        bins_free(&w->bins);
        w->bins = bins_make(w->numbers, w->n, per_bin);
    }
}

// A scan takes long enough for ten questions to be timed.
static int questions(int way)
{
    return way == SCAN ? 10 : QUESTIONS;
}

static void query(void *context)
{
    struct work *w = context;
    double width = (double)w->results / w->n;
    for (int q = 0; q < questions(w->way); q++) {
        double a = w->from[q] * (1 - width), b = a + width;
        w->count +=
            w->way == SCAN
                ? scan_between(w->numbers, w->n, a, b, w->found)
            : w->way == SORTED
                ? sorted_between(w->sorted, w->n, a, b, w->found)
                : bins_between(&w->bins, a, b, w->found);
    }
}

static void time_works(void (*work)(void *), struct work *works,
                       int trials, struct trial times[WAYS])
{
    for (int w = 0; w < WAYS; w++)
        times[w] = (struct trial){.work = work, .context = &works[w]};
    time_in_turn(trials, times, WAYS);
}

static void print_rows(struct work *works, int trials)
{
    static const char *const names[WAYS] = {"scan", "sorted", "bins"};
    struct trial built[WAYS], few[WAYS], many[WAYS];
    time_works(build, works, trials, built);
    time_works(query, works, trials, few);
    for (int w = 0; w < WAYS; w++)
        works[w].results = MANY_RESULTS;
    time_works(query, works, trials, many);
    for (int w = 0; w < WAYS; w++) {
        row_begin("%s_%u\t%u", names[w], works[w].n, works[w].n);
        row_times(&built[w].summary, works[w].n);
        row_times(&few[w].summary, questions(w));
        row_times(&many[w].summary, questions(w));
        row_end();
    }
}

static void compare_ways(uint32_t n, int trials)
{
    struct random random = {1};
    double *numbers = take(n, sizeof *numbers);
    double *from = take(QUESTIONS, sizeof *from);
    for (uint32_t i = 0; i < n; i++)
        numbers[i] = random_uniform(&random);
    for (int q = 0; q < QUESTIONS; q++)
        from[q] = random_uniform(&random);
    struct work works[WAYS];
    for (int w = 0; w < WAYS; w++)
        works[w] = (struct work){.way = w,
                                 .n = n,
                                 .results = FEW,
                                 .numbers = numbers,
                                 .sorted = take(n, sizeof(double)),
                                 .found = take(n, sizeof(double)),
                                 .from = from};
    print_rows(works, trials);
    bins_free(&works[BINS].bins);
    forget();
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t most = parameter(&e, "MOST", 100000, 10000, MANY);
    int trials = parameter(&e, "TRIALS", 3, 1, MANY);
    print_header(&e, "name n build:3 few:3 many:3");
    for (uint32_t n = 10000; n <= most; n *= 10)
        compare_ways(n, trials);
}

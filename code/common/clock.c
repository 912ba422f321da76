//> Measure time
// Runs something many times, and sorts the times for their median and
// quartiles; a quartile that falls between two is interpolated. As many
// runs as trials, and one to warm up.
#include "common/clock.h"
#include "common/fail.h"
#include <assert.h>
#include <stdlib.h>
#include <time.h>

//> Read the monotonic clock
int64_t clock_ns(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (int64_t)now.tv_sec * 1000000000 + now.tv_nsec;
}
//<

//> Find the value at a share of the way
static int by_value(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double quantile(const double *sorted, int n, double share)
{
    double place = share * (n - 1);
    int below = (int)place;
    if (below == n - 1)
        return sorted[below];
    return sorted[below] +
           (place - below) * (sorted[below + 1] - sorted[below]);
}
//<

//> Sum up repeated trials
struct summary summarize(double *values, int n)
{
    assert(n >= 1 && "nothing has no median");
    qsort(values, n, sizeof *values, by_value);
    return (struct summary){
        .min = values[0],
        .q1 = quantile(values, n, 0.25),
        .median = quantile(values, n, 0.5),
        .q3 = quantile(values, n, 0.75),
        .max = values[n - 1],
    };
}
//<

//> Time one run
static int64_t run_time(const struct trial *version)
{
    if (version->prepare)
        version->prepare(version->context);
    int64_t start = clock_ns();
    version->work(version->context);
    return clock_ns() - start;
}
//<

//> Time several versions in turn
void time_in_turn(int trials, struct trial *versions, int count)
{
    const size_t stride = trials;
    double *times = allocate(count * stride, sizeof *times);
    for (int v = 0; v < count; v++)
        run_time(&versions[v]); // warms caches and clock rate
    for (int trial = 0; trial < trials; trial++)
        for (int v = 0; v < count; v++)
            times[v * stride + trial] = run_time(&versions[v]);
    for (int v = 0; v < count; v++)
        versions[v].summary = summarize(times + v * stride, trials);
    free(times);
}
//<

//> Time one version
struct summary time_trials(int trials, void (*work)(void *),
                           void *context)
{
    struct trial version = {.work = work, .context = context};
    time_in_turn(trials, &version, 1);
    return version.summary;
}
//<
//<

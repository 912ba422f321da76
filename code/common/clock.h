//> The clock and the trials
// Time measured by the monotonic clock, in nanoseconds, and repeated
// trials summed up by their median and quartiles: on a machine with
// neighbors, a single time or a mean says little.
#pragma once
#include <stdint.h>

int64_t clock_ns(void);

struct summary {
    double min, q1, median, q3, max;
};

// Sorts values[0 .. n-1], n >= 1, and interpolates the quartiles.
struct summary summarize(double *values, int n);

// Runs work(context) once to warm up and then trials times; the
// summary is in nanoseconds a run.
struct summary time_trials(int trials, void (*work)(void *),
                           void *context);
//<

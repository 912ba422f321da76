//> Declare the clock
// Time measured by the monotonic clock, in nanoseconds, and repeated
// trials summed up by their median and quartiles: on a machine with
// neighbors, a single time or a mean says little.
#pragma once
#include <stdint.h>

int64_t clock_ns(void); // now; only differences mean something

struct summary {
    double min, q1, median, q3, max;
};

// Sorts values[0 .. n-1], n >= 1, and interpolates the quartiles.
struct summary summarize(double *values, int n);
//<

//> Declare the trials
// Something to be timed, and how long a run of it took, in nanoseconds.
struct trial {
    void (*work)(void *context);
    void *context;
    void (*prepare)(void *context); // untimed, before each run; or NULL
    struct summary summary;         // set by time_in_turn
};

// Runs every version once to warm up, then all of them in turn, trials
// times over: what disturbs the machine disturbs them alike, and they
// can be compared.
void time_in_turn(int trials, struct trial *versions, int count);

// The same for one version.
struct summary time_trials(int trials, void (*work)(void *),
                           void *context);
//<

//> Declare how the chapter compares
// Whole algorithms on the same points, timed trial by trial in turn.
// Times are nanoseconds per ordered pair, n (n-1) of them, whatever an
// algorithm really measures: half the work shows as half the time.
#pragma once
#include "common/clock.h"
#include "common/question.h"

typedef void search_function(const struct question *question,
                             struct answers *answers);

struct version {
    const char *name;
    search_function *serial;   // run on one thread
    search_function *parallel; // run on all processors
};

struct times {
    struct summary serial, parallel;
};

// Both searches of every version; times has room for count.
void compare(struct points points, enum geometry geometry, int trials,
             const struct version *versions, int count,
             struct times *times);

// n uniform points in the unit square; released with points_free.
struct points uniform_points(uint32_t n);

// Prints median and quartiles, each after a tab.
void print_times(const struct summary *summary);
//<

// Whole algorithms on the same points, timed trial by trial in turn. To
// be printed as nanoseconds per ordered pair, n (n - 1) of them, even
// if an algorithm measures fewer: half the work shows as half the time.
#pragma once
#include "common/clock.h"
#include "common/question.h"

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

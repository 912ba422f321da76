// Whole algorithms on the same points, on one thread and on all
// processors, timed trial by trial in turn. Printed as nanoseconds per
// ordered pair, n (n - 1) of them, even if an algorithm measures fewer:
// half the work shows as half the time.
#pragma once
#include "common/experiment.h"

struct version {
    const char *name;
    search_function *serial;   // run on one thread
    search_function *parallel; // run on all processors
};

// A row for each of count versions, named by prefix and name.
void compare(const struct question *question, int trials,
             const struct version *versions, int count,
             const char *prefix);

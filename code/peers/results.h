// The table of results: a row for every program on every instance, all
// times in ns a point. What was not measured is nan; a program that was
// not run has the time that was expected.
#pragma once
#include "peers/contest.h"

extern const char result_columns[]; // as print_header() wants them

// Which program, on how many points, of which kind, in which order, and
// with leaves of which size.
struct entry {
    const char *program, *kind, *order;
    uint32_t n;
    int leaf_size;
};

void print_result(const struct entry *entry,
                  const struct result *result);

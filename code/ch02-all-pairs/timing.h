//> Declare how the chapter times rows
// The experiments of this chapter time rows_functions on the same
// question and print nanoseconds a pair, as median and quartiles. Whole
// searches, threads and all, are timed alike.
#pragma once
#include "ch02-all-pairs/pair.h"
#include "common/clock.h"

struct run {
    rows_function *rows;
    const struct question *question;
    struct answers *answers;
    uint32_t begin, end;
};

// The work of a trial; the context is a struct run.
void run_rows(void *context);

struct search {
    search_function *search;
    struct question question;
    struct answers *answers;
};

// The same for a struct search.
void run_search(void *context);

// n uniform points in the unit square.
struct question uniform_question(enum geometry geometry, uint32_t n,
                                 uint64_t seed);

// Prints median and quartiles, each after a tab, divided by count.
void print_summary(const struct summary *summary, double count);
//<

//> Declare how experiments time
// Those of this chapter time rows_functions on the same question, those
// of later ones whole searches, threads and all. Printed are medians
// and quartiles, in nanoseconds.
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

// n points of a kind that generate knows, in the standard geometry, for
// one thread.
struct question kind_question(const char *kind, uint32_t n,
                              uint64_t seed);

// n uniform points in the unit square, for one thread.
struct question uniform_question(enum geometry geometry, uint32_t n,
                                 uint64_t seed);

// Prints the names of three columns, each after a tab, and under them
// median and quartiles, divided by count.
void print_summary_columns(const char *name);
void print_summary(const struct summary *summary, double count);
//<

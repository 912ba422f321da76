// Those who compete: some programs of this book and four libraries, and
// what is known of each from fewer points.
#pragma once
#include "common/experiment.h"
#include "peers/contest.h"

enum { MOST_CONTENDERS = 12, MOST_KINDS = 24 };

struct contender {
    struct program program;
    struct history history[MOST_KINDS];
    int leaf_size; // chosen on the first kind
};

struct contenders {
    int count;
    struct contender contender[MOST_CONTENDERS];
};

// The rows of the table of algorithms with these names, and then the
// libraries.
struct contenders contenders_of(const char *const *ours, int count);

// Heads the table of results, with the libraries and their flags.
void print_head(const struct experiment *experiment);

// The kind of points that an instance has, its number (the history has
// a place for each), and the order in which they are.
struct workload {
    const char *kind, *order;
    int number;
};

// All of them on this instance; a row of the table for each. Of the
// first kind and up to a million points each library chooses its leaf.
void compete_on(const struct workload *workload,
                const struct rules *rules, struct instance *instance,
                struct contenders *contenders);

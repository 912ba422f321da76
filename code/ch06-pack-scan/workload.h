//> Declare what is priced
// A primitive with arrays to work on, which take a given number of
// bytes all together: the working set. Indices in order are 0, 1, 2,
// and so on; at random, each of them once, shuffled. Pack keeps half,
// at random.
#pragma once
#include "ch06-pack-scan/primitives.h"
#include "common/clock.h"
#include <stddef.h>

enum work {
    ELEMENTWISE,
    GATHER_IN_ORDER,
    GATHER_AT_RANDOM,
    GATHER32_IN_ORDER,
    GATHER32_AT_RANDOM,
    SCATTER_IN_ORDER,
    SCATTER_AT_RANDOM,
    SCAN,
    PACK,
    WORKS
};

extern const char *const work_names[WORKS];

struct workload {
    enum work work;
    uint32_t n; // elements
    int rounds; // of the same call in one trial
    double *a, *b, *to;
    uint32_t *index, *a32, *to32;
    uint8_t *keep;
};

// To be released with workload_free.
struct workload workload_make(enum work work, size_t bytes);
void workload_free(struct workload *workload);

// Nanoseconds an element with each of count tables of primitives, timed
// in turn.
void workload_price(const struct workload *workload, int trials,
                    const struct primitives *const *tables, int count,
                    struct summary *prices);
//<

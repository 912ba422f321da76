// Declare what is priced.
// A primitive with arrays to work on, which take a given number of
// bytes all together: the working set. Indices in order are 0, 1, 2,
// and so on; at random, each of them once, shuffled. Pack keeps half,
// at random.
#pragma once
#include "ch06-pack-scan/primitives.h"
#include "common/experiment.h"

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
    uint32_t n;           // elements
    double *doubles[3];   // as many of each as the primitive needs
    uint32_t *numbers[3]; // an index is the first
    uint8_t *keep;
};

// To be released with workload_free.
struct workload workload_make(enum work work, size_t bytes);
void workload_free(struct workload *workload);

// A primitive of a table with its workload, and the nanoseconds that it
// takes for an element, set by price_in_turn.
struct priced {
    const struct primitives *primitives;
    const struct workload *workload;
    struct summary ns;
};

// Times all of them in turn.
void price_in_turn(int trials, struct priced *priced, int count);

// Times the primitives of several tables on working sets of so many
// bytes, and sets ns[table][work]. One primitive after the other: no
// two working sets share a cache. Its versions are timed in turn.
void price_tables(int trials, size_t bytes,
                  const struct primitives *const *tables, int count,
                  struct summary ns[][WORKS]);

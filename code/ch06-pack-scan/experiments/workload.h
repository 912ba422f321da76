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

// Times one kind of work with count tables of primitives in turn, on a
// working set of so many bytes, and sets ns[0 .. count-1]: nanoseconds
// an element.
void price_work(enum work work, size_t bytes, int trials,
                const struct primitives *const *tables, int count,
                struct summary *ns);

// All kinds of work with one table or several, one kind after the
// other: no two working sets share a cache. Sets ns[table][work].
void price_tables(int trials, size_t bytes,
                  const struct primitives *const *tables, int count,
                  struct summary ns[][WORKS]);

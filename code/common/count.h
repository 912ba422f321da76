//> Count what is done
// Operation counts, the one measurement that no other program can
// disturb. A thread keeps counts of its own and adds to them once a row
// or a span, never once a pair; what it has counted it adds to the
// question's counts, if there are any, once a chunk of its work.
#pragma once
#include <stdint.h>

struct counts {
    uint64_t distances, cells, tasks, collisions;
    uint64_t exact; // queries that a batch left to an exact search
};

// Adds what one thread has counted to a total that all threads share.
// If the total is NULL, counts are not wanted, and nothing is done.
void counts_add(struct counts *total, const struct counts *mine);
//<

//> Count what is done
// Operation counts that vanish in the ordinary build. Every module is
// compiled twice; with -DCOUNTING the macro adds to a shared counter,
// safely from any thread. Add once per row, not once per pair.
#pragma once
#include <stdint.h>

struct counts {
    uint64_t distances, cells, tasks, collisions;
};

// What was counted since the last call. It exists in the counting twin
// only and is called through count_operations.
struct counts counting_take(void);

#ifdef COUNTING
void count_add(uint64_t *counter, uint64_t amount);
extern struct counts counts;
#define COUNT(what, amount) count_add(&counts.what, amount)
#else
#define COUNT(what, amount) ((void)0)
#endif
//<

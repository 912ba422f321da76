//> Time the three loops
// For an experiment, on one thread: the time in each loop, and how
// often the search came to it.
#pragma once
#include "common/clock.h"
#include <stddef.h>

enum watched { IN_LAYERS, IN_CELLS, IN_POINTS, WATCHED };

struct watch {
    enum watched loop;
    int64_t since, ns[WATCHED];
    uint64_t entries[WATCHED];
};

// The search comes to this loop. Without a watch it costs a branch.
static inline void watch_loop(struct watch *watch, enum watched loop)
{
    if (!watch)
        return;
    int64_t now = clock_ns();
    watch->ns[watch->loop] += now - watch->since;
    watch->since = now;
    watch->loop = loop;
    watch->entries[loop]++;
}
//<

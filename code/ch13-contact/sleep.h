//> Declare sleep
// In a heap most bodies stay where they are, step after step. One that
// has done so for some steps sleeps: it is as good as fixed, and costs
// next to nothing until something that touches it leaves its place. (As
// in games; Bullet lets whole islands of bodies sleep.)
#pragma once
#include "ch13-contact/contact_cache.h"
#include "ch13-contact/motion.h"

//> Hold how long a body has stayed
struct rest {
    struct pose pose; // where it came to rest
    double reach;     // from its middle to its furthest node
    uint32_t steps;   // since then, in which something touched it
    bool touched;     // in this one
};

struct sleepers {
    struct rest *rest; // of each body
    uint32_t asleep;   // how many are
    uint32_t patience; // steps until a body sleeps; 0: none ever does
};
//<

// None is asleep yet. Released with sleepers_free.
struct sleepers sleepers_of(const struct scene *scene,
                            uint32_t patience);
void sleepers_free(struct sleepers *sleepers);

// After a step: lets bodies fall asleep, and wakes others.
void sleep_or_wake(struct sleepers *sleepers, struct scene *scene,
                   const struct contact_cache *cache);
//<

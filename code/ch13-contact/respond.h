//> Declare the response
// Events tell where bodies touch. They are remembered for some steps,
// and before each step impulses change velocities so that at these
// places nothing approaches (Baraff 1989; sequential impulses, Catto
// 2005).
#pragma once
#include "ch13-contact/find_events.h"

//> Hold what touches
struct touch {
    struct event event; // of which two, and with which weights
    double normal[3];   // of length 1, from the second to the first
    uint32_t age;       // steps since it was last seen
};

struct touches {
    struct touch *touch; // sorted by their nodes
    uint32_t count, room;
    struct touch *other; // as much room, for the next ones
    double friction;     // per unit of pressure
    uint32_t life;       // steps for which a touch is remembered
    int rounds;          // of impulses in a step
};
//<

// A step has passed; and: adds events to what is remembered, forgets
// what has not been seen for too long. {0} remembers nothing; released
// with touches_free.
void grow_old(struct touches *touches);
void remember(struct touches *touches, const struct scene *scene,
              const struct events *events);
void touches_free(struct touches *touches);

// Changes velocities by impulses at all touches, one after the other,
// in so many rounds.
void push_apart(const struct touches *touches, struct scene *scene);
//<

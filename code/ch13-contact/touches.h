//> Declare the touches
// Events tell where bodies touch; they are remembered for some steps.
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

// A step has passed, which ages nothing that touches a body that
// sleeps; and: adds events to what is remembered, forgets what has not
// been seen for too long. {0} remembers nothing; released with
// touches_free.
void grow_old(struct touches *touches, const struct scene *scene);
void remember(struct touches *touches, const struct scene *scene,
              const struct events *events);
void touches_free(struct touches *touches);

//> Hold a side of a touch
// Of a node and a face or of two edges, the first has split nodes.
struct side {
    const uint32_t *node;
    const double *weight;
    int count;
};
//<

// Which two bodies touch: of side 0 and of side 1.
void bodies_of_touch(const struct touch *touch,
                     const struct scene *scene, uint32_t two[2]);

// Side 0 or 1 of an event; and its weighted place, at a time of the
// step.
struct side side_of(const struct event *event, int side);
void place_of_side(const struct scene *scene, struct side side,
                   double time, double place[3]);
//<

//> Declare the contact cache
// Events tell where bodies touch. Such contacts are remembered for some
// steps, since bodies that are kept apart have no event for a while.
// (They are often called persistent contacts.)
#pragma once
#include "ch13-contact/find_events.h"

//> Hold a contact that lasts
struct contact {
    struct event event; // of which two, and with which weights
    double normal[3];   // of length 1, from the second to the first
    uint32_t age;       // steps since it was last seen
};

struct contact_cache {
    struct contact *contact; // sorted by their features
    uint32_t count, room;
    struct contact *other; // as much room, for the next ones
    double friction;       // per unit of pressure
    uint32_t max_age;      // an older contact is forgotten
    int rounds;            // of impulses in a step
};
//<

// A step has passed: makes contacts older by 1, unless a body that
// sleeps has part in them. These are not searched, and so not seen.
void contacts_age(struct contact_cache *cache,
                  const struct scene *scene);

// Adds events, with age 0; one whose features are there already takes
// the place of the old contact. Forgets what is older than max_age.
void contacts_merge(struct contact_cache *cache,
                    const struct scene *scene,
                    const struct events *events);

// {0} is an empty cache; released with this.
void contacts_free(struct contact_cache *cache);

//> Hold a feature
// What one of the two bodies has in a contact, a node, an edge or a
// face: its nodes, and the weights of the point that is touched.
struct feature {
    const uint32_t *node;
    const double *weight;
    int count;
};
//<

// Feature 0 or 1 of an event; and where its point is, at a time of the
// step.
struct feature feature_of(const struct event *event, int which);
void feature_position(const struct scene *scene, struct feature feature,
                      double time, double position[3]);

// Which two bodies touch: that of feature 0 and that of feature 1.
void bodies_of_contact(const struct contact *contact,
                       const struct scene *scene, uint32_t two[2]);
//<

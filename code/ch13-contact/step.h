//> Declare the step
// The lecture's loop: predict the nodes, capture triangles in boxes,
// find pairs of boxes that meet, find events among these pairs; then
// handle the events, and advance.
#pragma once
#include "ch13-contact/broad_phase.h"
#include "ch13-contact/respond.h"
#include "ch13-contact/sleep.h"

//> Hold what a step cost
enum phase { PREDICT, CAPTURE, BROAD, NARROW, HANDLE, PHASES };

struct step_report {
    uint64_t tested;     // pairs of boxes that were looked at
    uint64_t candidates; // pairs whose boxes meet
    uint64_t paired;     // of these, pairs in which something moves
    uint64_t apart;      // of these, separated by an axis
    uint64_t hits;       // of the others, pairs with an event
    uint64_t events;     // each once
    uint32_t contacts;   // remembered
    uint32_t asleep;     // bodies, after the step
    uint32_t stopped;    // nodes, by events of this step
    uint32_t rounds;     // until nothing that moves has an event
    struct event_counts tests;
    int64_t ns[PHASES];
};
//<

//> Hold a simulation
// The tolerance, unless another is set.
static const double DEFAULT_TOLERANCE = 1e-9;

// All arrays are kept from step to step. Bodies are apart at the
// beginning; then they are apart after every step.
struct simulation {
    struct scene scene;
    const struct broad_phase *broad_phase;
    void *kept; // by it
    double dt, tolerance;
    int threads;
    bool passive; // events are found, and not handled
    struct boxes boxes;
    struct pairs pairs;
    struct events events; // of the last step
    struct events more;   // of the rounds after the first
    struct contact_cache contacts;
    struct sleepers sleepers;
    uint32_t *stopped_in_round; // of each node: see find_events.h
};
//<

// Takes a complete scene, whose owner it is from then on, and works by
// so many threads. Released with simulation_free.
struct simulation simulation_of(struct scene scene,
                                const struct broad_phase *phase,
                                double dt, int threads);
void simulation_free(struct simulation *simulation);

struct step_report take_step(struct simulation *simulation);

// Finds the pairs of triangles whose boxes meet as they are now,
// without motion; and counts how many of them share a point, decided
// exactly.
void search_now(struct simulation *simulation);
uint64_t count_crossing(struct simulation *simulation);
//<

//> Declare the search for events
// The narrow phase over all candidates: each pair whose boxes meet is
// tested, and an event that several pairs report is kept once.
#pragma once
#include "ch13-contact/events.h"
#include "ch13-contact/pairs.h"

//> Hold the events of a step
struct event_list {
    struct event *event;
    uint64_t count, room;
    uint64_t hits;              // pairs that have an event
    uint64_t pairs;             // that were tested
    uint64_t apart;             // of these, separated by an axis
    struct event_counts counts; // of the tests
};

struct events {
    struct event_list all;   // sorted, each node and face, each two
                             // edges once: the earliest
    struct event_list *list; // of each thread
    int threads;
};
//<

//> Hold a search for events
// stopped_in_round[i] is the first round that finds node i stopped: 1
// if it cannot move at all, 2 if an event of round 1 has stopped it; 0
// if it moves. Only pairs are tested in which a node was stopped in
// this round and another one moves. In round 1, the first search, it is
// enough that one moves.
struct event_search {
    const struct scene *scene;
    const struct pairs *pairs;
    double tolerance;
    const uint32_t *stopped_in_round;
    uint32_t round;
    int threads;
};
//<

// The events of all pairs, in the order of their kinds and nodes; the
// ends of an edge, and then its two edges, lowest node first. {0} holds
// none; released with events_free. The order and the events are the
// same for any number of threads.
void find_events(struct events *events,
                 const struct event_search *search);
void events_free(struct events *events);

// How a triangle of the scene moves in this step.
struct moving_triangle moving_triangle_of(const struct scene *scene,
                                          uint32_t t);

// By kind and nodes alone: below 0, 0 or above 0, as qsort wants.
int compare_features(const struct event *a, const struct event *b);
//<

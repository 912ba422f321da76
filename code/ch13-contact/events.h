//> Declare the contact events
// When does a node first touch a face, or an edge an edge, while all
// corners move along straight lines over a step, the times 0 to 1?
// Nothing is missed: time and place are halved, and a piece is given up
// only if a plane, with an allowance for rounding, keeps the two apart
// all the while. Nothing far is reported: at the time of an event the
// two are within the tolerance of each other. (The idea: Snyder 1992,
// Redon and others 2002, Wang and others 2021.)
#pragma once
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

//> Hold what moves
struct moving {
    double begin[3], end[3]; // the place at time 0 and at time 1
};

struct moving_triangle {
    struct moving corner[3];
    uint32_t node[3]; // their numbers in the mesh, each once in all
};
//<

//> Hold a contact event
// Before time, the two do not touch. At that time they are no further
// apart than the tolerance, at the point with these weights: of a node
// (weight 1) and three corners of a face, or of an edge's two ends and
// another's. Each of the two has weights that sum to 1, and all are at
// least 0, but for rounding.
enum feature_kind { NODE_FACE, EDGE_EDGE };

struct event {
    enum feature_kind kind;
    uint32_t node[4]; // node, face; or edge, edge
    double time;      // from 0 to 1
    double weight[4]; // of these nodes
    double point[3];  // where the first of the two is touched
};
//<

//> Count the tests of events
// By what a test was settled: boxes, the four coefficients of a cubic,
// or halving, which looked at so many pieces.
struct event_counts {
    uint64_t tests, by_boxes, by_signs, pieces;
};
//<

// Whether the node touches the face during the step; then the event,
// but for its nodes. A tolerance below 2^-40 of the largest coordinate
// of a difference between the two counts as so much. Coordinates are
// finite, at most MAX_EXACT of exact.h, the tolerance is at least
// MIN_EXACT. Adds to *counts.
bool node_meets_face(const struct moving *node,
                     const struct moving face[3], double tolerance,
                     struct event *event, struct event_counts *counts);

// The same of two edges. They may be parallel, or points.
bool edge_meets_edge(const struct moving p[2], const struct moving q[2],
                     double tolerance, struct event *event,
                     struct event_counts *counts);

// All events of two triangles, with their nodes, in the order: nodes of
// p, nodes of q, edges. Returns how many. What shares a node is no
// event. Triangles that are apart at time 0 and meet during the step
// have an event; those that cross each other all the while need not.
enum { MAX_EVENTS = 15 };
size_t triangle_events(const struct moving_triangle *p,
                       const struct moving_triangle *q,
                       double tolerance, struct event event[MAX_EVENTS],
                       struct event_counts *counts);
//<

//> Declare the arcs
// The furthest of many corners: they stand in a round, so stretches of
// the round are arcs, eight of them are one longer arc, and the tree
// of these is searched, into no arc whose bound is less than the
// furthest so far. The bound of an arc knows how it is bent, so that of
// arcs along a circle few are entered, wherever the query is.
#pragma once
#include "ch10-furthest/hull.h"
#include "ch11-crowds/cut.h"
#include "common/workspace.h"
#include <stdbool.h>

//> Hold a node of eight arcs
// Eight arcs that follow each other, side by side for vectors. Seen
// from o, every corner v of an arc is within these distances along the
// unit vector t and at right angles to it, and |v|^2 is max2 at most,
// rounding included. The max2 of an arc without corners is -INFINITY.
enum { FANOUT = 8 };

struct arc_node {
    _Alignas(64) double left[FANOUT], right[FANOUT], bottom[FANOUT],
        top[FANOUT];
    double ox[FANOUT], oy[FANOUT], tx[FANOUT], ty[FANOUT], max2[FANOUT];
    double along[2][FANOUT], beside[2][FANOUT];
    uint32_t lowest[FANOUT]; // of the corners' indices
};
//<

//> Hold the tree of arcs
// The leaf arc k has the corners PER_ARC k and following. Arc k of a
// level is in node k / FANOUT there, and the whole of that node is an
// arc of the next level, where it has the number of the node.
enum { PER_ARC = 8, MAX_ARC_LEVELS = 12 };

struct arcs {
    struct points points; // the corners, once round
    uint32_t *point;      // their indices
    uint32_t padded_n; // rounded up to PER_ARC: the last corner again
    double diameter;   // diagonal of the box of all corners
    int levels;        // the last has a single node
    struct arc_node *level[MAX_ARC_LEVELS];
};
//<

// Of at least one corner, whose box has a squared diagonal that neither
// vanishes nor overflows. All arrays are taken from the workspace.
struct arcs arcs_make(const struct corners *corners,
                      struct workspace *workspace);

//> Hold a query for the furthest corner
struct arc_query {
    double x, y, max2;
    uint32_t furthest; // the index of a point
    uint32_t corner;   // its place in the round
    uint64_t compared;
};
//<

// Finds the furthest corner, of several the one of the lowest index; it
// is tried first whether the corner that the query has is far.
void arcs_furthest(const struct arcs *arcs, struct arc_query *query);

//> Hold a shortlist
// Nodes of leaf arcs, and of each some of its arcs as bits. Complete,
// if the furthest corners of all points in a box are in them. Short, if
// these are among a few corners.
enum { MAX_LISTED = 16, MAX_CORNERS = 16 };
enum { ALL_ARCS = (1 << FANOUT) - 1 };

struct shortlist {
    bool complete, is_short;
    int nodes, corners;
    uint32_t node[MAX_LISTED], set[MAX_LISTED];
    uint32_t corner[MAX_CORNERS];
};
//<

// Makes the list for the points in a box, which are among those that
// the corners are of; the corner of the query is a guess.
void arcs_list(const struct arcs *arcs, const struct box *box,
               struct arc_query *query, struct shortlist *list);

// As arcs_furthest, for a query in the box of a list that is complete.
void arcs_furthest_listed(const struct arcs *arcs,
                          const struct shortlist *list,
                          struct arc_query *query);

// The box of n >= 1 points.
struct box box_around(struct points points);
//<

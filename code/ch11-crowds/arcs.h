//> Declare the arcs
// The furthest of many corners: they stand in a round, so halves of the
// round, quarters and so on are arcs, and a tree over them is searched
// down from the whole, into no arc whose bound is less than the
// furthest so far. The bound of an arc knows how it is bent, so that of
// arcs along a circle few are entered, wherever the query is.
#pragma once
#include "ch10-furthest/hull.h"
#include "ch11-crowds/cut.h"
#include "common/workspace.h"

//> Hold an arc
// Seen from o, every corner v of it is within these distances along the
// unit vector t and at right angles to it, and |v|^2 is max2 at most.
struct arc {
    struct box box;
    double ox, oy, tx, ty;
    double along[2], beside[2], max2, margin;
    uint32_t lowest; // of the corners' indices
};
//<

//> Hold the tree of arcs
// Arc k is made of the arcs 2 k + 1 and 2 k + 2; those without have at
// most PER_ARC corners.
struct arcs {
    struct points points; // the corners, once round
    uint32_t *point;      // their indices
    struct arc *arc;
    uint32_t leaves; // a power of two
};
enum { PER_ARC = 8 };
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
//<

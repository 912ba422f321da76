//> Declare the steps of a search among arcs
// What the search of the whole round and that of a shortlist share.
#pragma once
#include "ch11-crowds/arcs.h"

//> Choose among eight
// Those of the values that are at least min, as bits.
static inline uint32_t at_least(const double value[FANOUT], double min)
{
    uint32_t set = 0;
    for (int k = 0; k < FANOUT; k++)
        set |= (uint32_t)(value[k] >= min) << k;
    return set;
}
//<

// The bounds of a node's arcs, seen from (x, y).
void arcs_bound(const struct arc_node *node, double x, double y,
                double bound[FANOUT]);

// Compares the query with the corners of a leaf arc.
void arcs_compare_leaf(const struct arcs *arcs, uint32_t leaf,
                       struct arc_query *query);

// Searches a node of a level, and those below it, but of its arcs only
// those of this set.
void arcs_search_node(const struct arcs *arcs, int level,
                      uint32_t number, uint32_t set,
                      struct arc_query *query);
//<

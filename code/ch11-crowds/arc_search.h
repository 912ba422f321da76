//> Declare the steps of a search among arcs
// What the search of the whole round and that of a shortlist share.
#pragma once
#include "ch11-crowds/arcs.h"

//> Choose among eight
// Those that are no less than something, as bits; and the best of some.
static inline uint32_t no_less(const double value[FAN], double least)
{
    uint32_t set = 0;
    for (int k = 0; k < FAN; k++)
        set |= (uint32_t)(value[k] >= least) << k;
    return set;
}
//<

// The bounds of a fan's arcs from this place.
void arcs_bound(const struct fan *fan, double x, double y,
                double bound[FAN]);

// Compares the query with the corners of a leaf arc.
void arcs_compare_leaf(const struct arcs *arcs, uint32_t leaf,
                       struct arc_query *query);

// Searches a fan of a level, and those below it, but of its arcs only
// those of this set.
void arcs_search_fan(const struct arcs *arcs, int level,
                     uint32_t number, uint32_t set,
                     struct arc_query *query);
//<

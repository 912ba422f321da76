//> Declare the neighbors
// All points within a distance of a query, or the k nearest to it.
// Squared distances are sums in the order of the coordinates, from 0
// on: the same to the last bit, whatever structure finds them.
#pragma once
#include "ch12-range-queries/k_nearest_list.h"
#include "ch12-range-queries/scan.h"

//> Hold a query for neighbors
struct neighbor_query {
    const double *at;    // d coordinates: where the query is
    uint32_t self;       // a point that is not wanted, or NO_INDEX
    bool nearest;        // only the k nearest, of equal ones the lowest
    uint32_t k;          // how many are wanted; if not nearest, room
    double reach2;       // no neighbor is further, squared
    uint32_t count;      // found so far
    struct found *found; // [count]; the nearest ones in their order
    uint64_t steps, tested;
};
//<

// Before a search: none found yet. k >= 1, with room for k; for all
// within a distance, room for all points.
void want_nearest(struct neighbor_query *query, uint32_t k);
void want_within(struct neighbor_query *query, double distance);

// By a scan of all points.
void scan_neighbors(const struct point_set *points,
                    struct neighbor_query *query);

// Takes places begin to end - 1, as far as they are wanted.
void take_neighbors(const struct sorted_points *sorted, uint32_t begin,
                    uint32_t end, struct neighbor_query *query);
//<

//> Declare the query over all pieces
// The nearest or the furthest of one point, exactly: down the tree of
// boxes, the better side first, and into no box whose bound is worse
// than the best so far. It gives up after a number of steps.
#pragma once
#include "ch09-row-spans/point_query.h"
#include "ch11-crowds/pieces.h"

//> Hold a query over all pieces
// Its best is a squared distance, for the furthest with its sign
// turned: the less, the better. Among equals the lower index.
struct tree_query {
    const struct pieces *pieces;
    const struct scene *all;   // the space, all sorted points
    struct query query;        // as in chapter 9
    uint64_t steps, max_steps; // rows, boxes and distances
};
//<

// Looks for a better neighbor than the query has. If it gives up, it
// says false, and the best so far may not be the best.
bool query_nearest(struct tree_query *query);
bool query_furthest(struct tree_query *query);

// Compares with the sorted points begin .. end - 1.
void compare_nearest(struct tree_query *query, uint32_t begin,
                     uint32_t end);
void compare_furthest(struct tree_query *query, uint32_t begin,
                      uint32_t end);
//<

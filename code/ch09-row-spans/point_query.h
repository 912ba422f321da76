//> Declare the exact point query
// The nearest neighbor of one point, in double precision: the row spans
// of its block, its own row first, and another row only if it can hold
// a point as near as the nearest so far (pruning). If the nearest in
// the block is not nearer than all that is outside, the block is
// doubled. It answers what a batch leaves in doubt.
#pragma once
#include "ch09-row-spans/batch.h"

//> Hold a point query
struct point_query {
    double x, y, best2;
    uint32_t self, nearest; // indices of points
    uint64_t compared;      // with how many points
};

// Keeps the nearer of two candidates; of a tie the lower index.
static inline void query_keep(struct point_query *query, double near2,
                              uint32_t candidate)
{
    if (near2 < query->best2 ||
        (near2 == query->best2 && candidate < query->nearest)) {
        query->best2 = near2;
        query->nearest = candidate;
    }
}
//<

//> Declare how a query meets a span
// Compares a query with the sorted points begin .. end - 1.
typedef void compare_function(const struct scene *scene, uint32_t begin,
                              uint32_t end, struct point_query *query);
//<

// The query of sorted point s, not yet compared with any.
struct point_query query_of(const struct sorted *sorted, uint32_t s);

// Compares a query with one row of a block.
void compare_row(const struct scene *scene, const struct range *range,
                 uint32_t row, struct point_query *query);

// Whether no point of the row can be as near as the nearest so far.
bool prune_row(const struct scene *scene, uint32_t row,
               const struct point_query *query);

// All of it: the nearest neighbor of sorted point s.
struct point_query nearest_query(const struct scene *scene, uint32_t s);
//<

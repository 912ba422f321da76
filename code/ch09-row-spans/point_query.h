//> Declare the exact point query
// The nearest neighbor of one point, in double precision: the row spans
// of its block, its own row first, and another row only if it can hold
// a point as near as the nearest so far (pruning). If the nearest in
// the block is not nearer than all that is outside, the block is
// doubled. It answers what a batch leaves in doubt.
#pragma once
#include "ch04-cell-sort/visit.h"
#include "ch09-row-spans/batch.h"
#include <stddef.h>

//> Begin a query
// The query of sorted point s, not yet compared with any.
static inline struct query query_of(const struct sorted *sorted,
                                    uint32_t s)
{
    return query_at(sorted->points.x[s], sorted->points.y[s],
                    sorted->cells.point[s], NULL);
}
//<

//> Declare how a query meets a span
// Compares a query with the sorted points begin .. end - 1.
typedef void compare_function(const struct scene *scene, uint32_t begin,
                              uint32_t end, struct query *query);
//<

// Compares a query with one row of a block.
void compare_row(const struct scene *scene,
                 const struct axis_range *range, uint32_t row,
                 struct query *query);

// Whether no point of the row can be as near as the nearest so far.
bool prune_row(const struct scene *scene, uint32_t row,
               const struct query *query);

// All of it: the nearest neighbor of sorted point s.
struct query nearest_query(const struct scene *scene, uint32_t s);
//<

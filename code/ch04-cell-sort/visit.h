//> Visit cells for a query
// A query is compared with the points of a cell, whose cells are stored
// in one of three ways, and so with those of a block. All of it is
// INLINED: a search is compiled once for each way and each geometry.
// Ties go to the lowest index, whatever the order of the visits.
#pragma once
#include "ch02-all-pairs/pair.h"
#include "ch04-cell-sort/block.h"
#include "ch04-cell-sort/lists.h"
#include "ch04-cell-sort/sorted.h"

//> Hold a query and its best candidate
struct query {
    double x, y;
    uint32_t self;         // its own index
    uint32_t nearest;      // the best candidate so far, or NO_INDEX
    double best2;          // its squared distance, or INFINITY
    uint64_t compared;     // points of the cells visited
    struct counts *counts; // of the thread
};

INLINED struct query query_at(double x, double y, uint32_t self,
                              struct counts *counts)
{
    return (struct query){x, y, self, NO_INDEX, INFINITY, 0, counts};
}
//<

//> Compare a query with a candidate
INLINED void query_keep(struct query *q, uint32_t j, double distance2)
{
    if (distance2 < q->best2 ||
        (distance2 == q->best2 && j < q->nearest)) {
        q->best2 = distance2;
        q->nearest = j;
    }
}

// With point j, whose coordinates are in place s, unless it is the
// query itself.
INLINED void compare(const enum geometry geometry, struct space space,
                     struct points p, uint32_t s, uint32_t j,
                     struct query *q)
{
    if (j != q->self)
        query_keep(
            q, j,
            pair2(geometry, space, p.x[s] - q->x, p.y[s] - q->y).near2);
}
//<

//> Say how the cells are stored
// As lists or as an array: the other one is NULL. The points are in the
// order of the input, or of the cells: then index[s] is the index of
// the point in place s. NULL: its place is its index.
struct storage {
    const struct grid *grid;
    const struct lists *lists;
    const struct cells *cells;
    struct points points;
    const uint32_t *index;
};

// Compares a query with all points of a cell but itself.
typedef void visit_function(const enum geometry geometry,
                            struct space space,
                            const struct storage *storage,
                            uint32_t cell, struct query *query);
//<

//> Visit a list
INLINED void visit_list(const enum geometry geometry,
                        struct space space,
                        const struct storage *storage, uint32_t cell,
                        struct query *query)
{
    const uint32_t *next = storage->lists->next;
    uint32_t j = storage->lists->head[cell];
    for (; j != NO_INDEX; j = next[j]) {
        query->compared++;
        compare(geometry, space, storage->points, j, j, query);
    }
}
//<

//> Visit a cell through its indices
INLINED void visit_indices(const enum geometry geometry,
                           struct space space,
                           const struct storage *storage, uint32_t cell,
                           struct query *query)
{
    const struct cells *cells = storage->cells;
    uint32_t end = cells->start[cell + 1];
    query->compared += end - cells->start[cell];
    for (uint32_t s = cells->start[cell]; s < end; s++)
        compare(geometry, space, storage->points, cells->point[s],
                cells->point[s], query);
}
//<

//> Visit a cell of sorted points
INLINED void visit_sorted(const enum geometry geometry,
                          struct space space,
                          const struct storage *storage, uint32_t cell,
                          struct query *query)
{
    const struct cells *cells = storage->cells;
    uint32_t end = cells->start[cell + 1];
    query->compared += end - cells->start[cell];
    for (uint32_t s = cells->start[cell]; s < end; s++)
        compare(geometry, space, storage->points, s, cells->point[s],
                query);
}
//<

//> Visit the cells of a block
INLINED void visit_block(const enum geometry geometry,
                         struct space space,
                         const struct storage *storage,
                         const struct block *block,
                         visit_function *visit, struct query *query)
{
    const struct grid *grid = storage->grid;
    query->compared = 0;
    for (uint32_t r = 0; r < block->y.count; r++) {
        uint32_t row = range_cell(&grid->y, &block->y, r);
        for (uint32_t k = 0; k < block->x.count; k++) {
            uint32_t column = range_cell(&grid->x, &block->x, k);
            visit(geometry, space, storage,
                  row * grid->x.count + column, query);
        }
    }
    query->counts->cells += (uint64_t)block->x.count * block->y.count;
    query->counts->distances += query->compared - 1; // not with itself
}
//<
//<

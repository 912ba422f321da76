//> Search in two phases
// The nearest neighbor of one point by spiral search (Bentley, Weide
// and Yao, 1980), with the square in place of the circle (Su). Phase
// one goes out from the point's cell, layer by layer, until a layer
// has another point, at distance D. Phase two visits every other cell
// that meets the square of side 2D around the point. For points
// scattered evenly that is a constant number of cells.
#pragma once
#include "ch02-all-pairs/pair.h"
#include "ch04-cell-sort/cells.h"
#include "ch07-spiral/search_range.h"

//> Declare what is searched
struct map {
    const struct grid *grid;
    const struct cells *cells;
    struct points points; // in the order of the input
    struct space space;
};
//<

//> Remember the state of a search
struct spiral_query {
    double x, y, best2;        // best2: squared distance to `nearest`
    uint32_t self, nearest;    // points; at first nearest is NO_INDEX
    uint32_t column, row;      // the cell of (x, y)
    uint64_t cells, distances; // cells visited, points compared
};
//<

//> Begin a search
static inline struct spiral_query spiral_query_at(const struct map *map,
                                                  uint32_t i)
{
    double x = map->points.x[i], y = map->points.y[i];
    return (struct spiral_query){.x = x,
                                 .y = y,
                                 .best2 = INFINITY,
                                 .self = i,
                                 .nearest = NO_INDEX,
                                 .column = axis_cell(&map->grid->x, x),
                                 .row = axis_cell(&map->grid->y, y)};
}
//<

//> Declare what is done at a cell
// What to do at a cell: visit_cell, or a function that notes the cell
// and calls it. A constant at every call, so that it is compiled into
// the loops.
typedef void spiral_visit(const enum geometry geometry,
                          const struct map *map, uint32_t cell,
                          struct spiral_query *query);
//<

//> Visit a cell
// Compares all its points but the query itself. Ties go to the lowest
// index.
INLINED void visit_cell(const enum geometry geometry,
                        const struct map *map, uint32_t cell,
                        struct spiral_query *query)
{
    const struct points p = map->points;
    const uint32_t *start = map->cells->start;
    query->cells++;
    for (uint32_t s = start[cell]; s < start[cell + 1]; s++) {
        uint32_t j = map->cells->point[s];
        if (j == query->self)
            continue;
        query->distances++;
        double d2 = pair2(geometry, map->space, p.x[j] - query->x,
                          p.y[j] - query->y)
                        .near2;
        if (d2 < query->best2 ||
            (d2 == query->best2 && j < query->nearest)) {
            query->best2 = d2;
            query->nearest = j;
        }
    }
}
//<

//> Visit a layer
// Those of its cells that are in the box: row by row; all columns of
// its first and last row, the two ends of the rows between.
INLINED void visit_layer(const enum geometry geometry,
                         const struct map *map,
                         const struct search_box *box, int32_t k,
                         spiral_visit *visit,
                         struct spiral_query *query)
{
    const struct axis *x = &map->grid->x, *y = &map->grid->y;
    const uint32_t column = query->column;
    const struct search_range wide = box->x, tall = box->y;
    int32_t top = MIN(k, tall.ahead);
    int32_t right = MIN(k, wide.ahead);
    for (int32_t dy = -MIN(k, tall.back); dy <= top; dy++) {
        uint32_t first = step(y, query->row, dy) * x->count;
        if (dy == -k || dy == k) {
            for (int32_t dx = -MIN(k, wide.back); dx <= right; dx++)
                visit(geometry, map, first + step(x, column, dx),
                      query);
            continue;
        }
        if (k <= wide.back)
            visit(geometry, map, first + step(x, column, -k), query);
        if (k <= wide.ahead)
            visit(geometry, map, first + step(x, column, k), query);
    }
}
//<

//> Go out layer by layer, then search the square
INLINED void spiral_nearest(const enum geometry geometry,
                            const struct map *map, spiral_visit *visit,
                            struct spiral_query *query)
{
    const struct axis *x = &map->grid->x, *y = &map->grid->y;
    struct search_box whole = {whole_range(x, query->column),
                               whole_range(y, query->row)};
    int32_t k = 0;
    while (query->nearest == NO_INDEX)
        visit_layer(geometry, map, &whole, k++, visit, query);
    const double best2 = query->best2; // D, squared
    struct search_box square = {
        square_range(geometry, x, whole.x, query->column, query->x,
                     best2),
        square_range(geometry, y, whole.y, query->row, query->y,
                     best2)};
    int32_t last = MAX(MAX(square.x.back, square.x.ahead),
                       MAX(square.y.back, square.y.ahead));
    for (; k <= last; k++)
        visit_layer(geometry, map, &square, k, visit, query);
}
//<
//<

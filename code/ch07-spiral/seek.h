//> Seek in two phases
// Bentley, Weide and Yao's spiral search for the nearest neighbor of
// one point (1980), with the square in place of the circle (Su). Phase
// one goes out from the point's cell, layer by layer, until a layer
// holds another point. Let D be the distance to the nearest one there.
// Phase two looks at every other cell that meets the square of side 2D
// around the point. What it is to look at a cell, the caller says.
#pragma once
#include "ch04-cell-sort/cells.h"
#include "ch04-cell-sort/lists.h"
#include "ch07-spiral/window.h"

struct map {
    const struct grid *grid;
    const struct cells *cells;
    struct points points; // in the order of the input
    struct space space;
};

//> Remember where a search stands
struct seeker {
    double x, y, best2;
    uint32_t self, nearest; // indices; at first NOBODY is near
    uint64_t looked, met;   // cells looked at, other points in them
};

static inline struct seeker seeker_at(struct points points, uint32_t i)
{
    return (struct seeker){points.x[i], points.y[i], INFINITY, i,
                           NOBODY,      0,           0};
}
//<

typedef void look_function(const enum geometry geometry,
                           const struct map *map, uint32_t cell,
                           struct seeker *seeker);

//> Look at a cell
INLINED void look_at_cell(const enum geometry geometry,
                          const struct map *map, uint32_t cell,
                          struct seeker *seeker)
{
    const struct points p = map->points;
    const uint32_t *start = map->cells->start;
    seeker->looked++;
    for (uint32_t s = start[cell]; s < start[cell + 1]; s++) {
        uint32_t j = map->cells->point[s];
        if (j == seeker->self)
            continue;
        seeker->met++;
        double d2 = pair2(geometry, map->space, p.x[j] - seeker->x,
                          p.y[j] - seeker->y)
                        .near2;
        if (d2 < seeker->best2 ||
            (d2 == seeker->best2 && j < seeker->nearest)) {
            seeker->best2 = d2;
            seeker->nearest = j;
        }
    }
}
//<

//> Look at a layer
// At those of its cells that are in the window.
INLINED void look_at_layer(const enum geometry geometry,
                           const struct map *map, uint32_t column,
                           uint32_t row, const struct window *window,
                           int32_t k, look_function *look,
                           struct seeker *seeker)
{
    const struct axis *x = &map->grid->x, *y = &map->grid->y;
    const struct view wide = window->x, tall = window->y;
    int32_t top = fewer(k, tall.on), right = fewer(k, wide.on);
    for (int32_t dy = -fewer(k, tall.back); dy <= top; dy++) {
        uint32_t first = step(y, row, dy) * x->count;
        if (dy == -k || dy == k) {
            for (int32_t dx = -fewer(k, wide.back); dx <= right; dx++)
                look(geometry, map, first + step(x, column, dx),
                     seeker);
            continue;
        }
        if (k <= wide.back)
            look(geometry, map, first + step(x, column, -k), seeker);
        if (k <= wide.on)
            look(geometry, map, first + step(x, column, k), seeker);
    }
}
//<

//> Go out, then look through the square
INLINED void seek(const enum geometry geometry, const struct map *map,
                  look_function *look, struct seeker *seeker)
{
    const struct axis *x = &map->grid->x, *y = &map->grid->y;
    uint32_t column = axis_cell(x, seeker->x);
    uint32_t row = axis_cell(y, seeker->y);
    struct window all = {view_all(x, column), view_all(y, row)};
    int32_t k = 0;
    while (seeker->nearest == NOBODY)
        look_at_layer(geometry, map, column, row, &all, k++, look,
                      seeker);
    double best2 = seeker->best2;
    struct window square = {
        view_square(geometry, x, all.x, column, seeker->x, best2),
        view_square(geometry, y, all.y, row, seeker->y, best2)};
    int32_t last = more(more(square.x.back, square.x.on),
                        more(square.y.back, square.y.on));
    for (; k <= last; k++)
        look_at_layer(geometry, map, column, row, &square, k, look,
                      seeker);
}
//<
//<

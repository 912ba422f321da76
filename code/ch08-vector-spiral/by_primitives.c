//> Write the loops with primitives
// See loops.h. Chapter 6's primitives, and between them loops over
// arrays, element by element.
#include "ch08-vector-spiral/by_primitives.h"
#include <stdlib.h>

//> Enter a cell
INLINED void enter_in(const enum geometry geometry,
                      const struct map *map, struct strip *strip,
                      const struct tasks *tasks, int32_t dx, int32_t dy)
{
    const struct primitives *p = strip->primitives;
    const struct axis *x = &map->grid->x, *y = &map->grid->y;
    const uint32_t *start = map->cells->start;
    const int32_t *aside = tasks->reach[dx < 0 ? WEST : EAST];
    const int32_t *ahead = tasks->reach[dy < 0 ? SOUTH : NORTH];
    const int32_t *column = tasks->column, *row = tasks->row;
    struct visits *here = &strip->here;
    uint32_t *cell = strip->cell, n = tasks->n;
    uint8_t *keep = strip->keep;
    //> Go to the cell, if the window shows it
    const int32_t across = abs(dx), along = abs(dy);
#pragma omp simd
    for (uint32_t i = 0; i < n; i++)
        keep[i] = (aside[i] >= across) & (ahead[i] >= along);
#pragma omp simd
    for (uint32_t i = 0; i < n; i++)
        cell[i] = go(geometry, y, row[i], dy) * x->count +
                  go(geometry, x, column[i], dx);
    p->pack(cell, cell, keep, n);
    n = p->pack(here->task, tasks->task, keep, n);
    strip->tally.looked += n;
    //<
    //> Stay if it has points
    p->gather32(here->at, start, cell, n);
    p->gather32(here->end, start + 1, cell, n);
#pragma omp simd
    for (uint32_t i = 0; i < n; i++)
        keep[i] = here->at[i] < here->end[i];
    p->pack(here->at, here->at, keep, n);
    p->pack(here->end, here->end, keep, n);
    here->n = p->pack(here->task, here->task, keep, n);
    //<
}
//<

//> Look at a point
INLINED void look_in(const enum geometry geometry,
                     const struct map *map, struct strip *strip)
{
    const struct primitives *p = strip->primitives;
    struct visits *here = &strip->here;
    uint32_t *task = here->task, *at = here->at, *end = here->end;
    uint32_t *point = strip->point, *least = strip->least;
    double *x = strip->point_x, *y = strip->point_y;
    double *task_x = strip->task_x, *task_y = strip->task_y;
    double *best = strip->best;
    uint8_t *keep = strip->keep;
    uint32_t n = here->n;
    //> Gather what is compared
    p->gather32(point, map->cells->point, at, n);
    p->gather(x, map->points.x, point, n);
    p->gather(y, map->points.y, point, n);
    p->gather(task_x, strip->x, task, n);
    p->gather(task_y, strip->y, task, n);
    p->gather(best, strip->best2, task, n);
    p->gather32(least, strip->nearest, task, n);
    //<
    //> Keep what is nearer
#pragma omp simd
    for (uint32_t i = 0; i < n; i++) {
        double d2 = pair2(geometry, map->space, x[i] - task_x[i],
                          y[i] - task_y[i])
                        .near2;
        bool self = at[i] == strip->first + task[i];
        bool better = ((d2 < best[i]) |
                       ((d2 == best[i]) & (point[i] < least[i]))) &
                      !self;
        best[i] = better ? d2 : best[i];
        least[i] = better ? point[i] : least[i];
    }
    p->scatter(strip->best2, best, task, n);
    p->scatter32(strip->nearest, least, task, n);
    //<
    //> Go on to the next point
#pragma omp simd
    for (uint32_t i = 0; i < n; i++) {
        at[i]++;
        keep[i] = at[i] < end[i];
    }
    p->pack(at, at, keep, n);
    p->pack(end, end, keep, n);
    here->n = p->pack(task, task, keep, n);
    //<
}
//<

//> Take the copy for the geometry
static void enter(const struct map *map, struct strip *strip,
                  const struct tasks *tasks, int32_t dx, int32_t dy)
{
    if (map->space.geometry == STANDARD)
        enter_in(STANDARD, map, strip, tasks, dx, dy);
    else
        enter_in(WRAPAROUND, map, strip, tasks, dx, dy);
}

static void look(const struct map *map, struct strip *strip)
{
    if (map->space.geometry == STANDARD)
        look_in(STANDARD, map, strip);
    else
        look_in(WRAPAROUND, map, strip);
}

struct loops loops_by_primitives(enum isa isa)
{
    return (struct loops){isa, enter, look};
}
//<
//<

//> Write the kernels with primitives
// Chapter 6's primitives, and between them loops over arrays, element
// by element. Each of these reads what the one before has left in the
// arrays of the strip.
#include "ch08-vector-spiral/by_primitives.h"
#include <stdlib.h>

//> Keep the tasks that may take the step
INLINED uint32_t take_step(const enum geometry geometry,
                           const struct map *map, struct strip *strip,
                           const struct tasks *tasks, int32_t dx,
                           int32_t dy)
{
    const struct primitives *p = strip->primitives;
    const struct axis *x = &map->grid->x, *y = &map->grid->y;
    uint32_t *cell = strip->cell, n = tasks->n;
    uint8_t *keep = strip->keep;
    //> Compare with the bounds on two sides
    const int32_t *bound_x = tasks->bound[dx < 0 ? WEST : EAST];
    const int32_t *bound_y = tasks->bound[dy < 0 ? SOUTH : NORTH];
    const int32_t steps_x = abs(dx), steps_y = abs(dy);
#pragma omp simd
    for (uint32_t i = 0; i < n; i++)
        keep[i] = (bound_x[i] >= steps_x) & (bound_y[i] >= steps_y);
    //<
    //> Compute the number of the cell
    const int32_t *column = tasks->column, *row = tasks->row;
#pragma omp simd
    for (uint32_t i = 0; i < n; i++)
        cell[i] = cell_after(geometry, y, row[i], dy) * x->count +
                  cell_after(geometry, x, column[i], dx);
    //<
    p->pack(cell, cell, keep, n);
    return p->pack(strip->here.task, tasks->task, keep, n);
}
//<

//> Keep the tasks whose cell has points
static void keep_entered(const struct map *map, struct strip *strip,
                         uint32_t n)
{
    const struct primitives *p = strip->primitives;
    const uint32_t *start = map->cells->start, *cell = strip->cell;
    struct visits *here = &strip->here;
    uint8_t *keep = strip->keep;
    p->gather32(here->at, start, cell, n);
    p->gather32(here->end, start + 1, cell, n);
#pragma omp simd
    for (uint32_t i = 0; i < n; i++)
        keep[i] = here->at[i] < here->end[i];
    p->pack(here->at, here->at, keep, n);
    p->pack(here->end, here->end, keep, n);
    here->n = p->pack(here->task, here->task, keep, n);
}
//<

//> Enter a cell by primitives
INLINED void enter_in(const enum geometry geometry,
                      const struct map *map, struct strip *strip,
                      const struct tasks *tasks, int32_t dx, int32_t dy)
{
    uint32_t n = take_step(geometry, map, strip, tasks, dx, dy);
    strip->tally.visited += n;
    keep_entered(map, strip, n);
}
//<

//> Gather what is compared
static void gather_compared(const struct map *map, struct strip *strip)
{
    const struct primitives *p = strip->primitives;
    const uint32_t *task = strip->here.task, *at = strip->here.at;
    uint32_t *point = strip->point, n = strip->here.n;
    p->gather32(point, map->cells->point, at, n);
    p->gather(strip->point_x, map->points.x, point, n);
    p->gather(strip->point_y, map->points.y, point, n);
    p->gather(strip->task_x, strip->x, task, n);
    p->gather(strip->task_y, strip->y, task, n);
    p->gather(strip->best, strip->best2, task, n);
    p->gather32(strip->gathered_nearest, strip->nearest, task, n);
}
//<

//> Keep what is nearer
INLINED void keep_nearer(const enum geometry geometry,
                         const struct map *map, struct strip *strip)
{
    const uint32_t *task = strip->here.task, *at = strip->here.at;
    const uint32_t *point = strip->point, n = strip->here.n;
    const double *x = strip->point_x, *y = strip->point_y;
    const double *task_x = strip->task_x, *task_y = strip->task_y;
    double *best = strip->best;
    uint32_t *gathered_nearest = strip->gathered_nearest;
    //> Compare element by element
#pragma omp simd
    for (uint32_t i = 0; i < n; i++) {
        double d2 = pair2(geometry, map->space, x[i] - task_x[i],
                          y[i] - task_y[i])
                        .near2;
        bool self = at[i] == strip->first + task[i];
        bool better =
            ((d2 < best[i]) |
             ((d2 == best[i]) & (point[i] < gathered_nearest[i]))) &
            !self;
        best[i] = better ? d2 : best[i];
        gathered_nearest[i] = better ? point[i] : gathered_nearest[i];
    }
    //<
    const struct primitives *p = strip->primitives;
    p->scatter(strip->best2, best, task, n);
    p->scatter32(strip->nearest, gathered_nearest, task, n);
}
//<

//> Go on to the next point
static void next_point(struct strip *strip)
{
    const struct primitives *p = strip->primitives;
    struct visits *here = &strip->here;
    uint32_t *at = here->at, *end = here->end, n = here->n;
    uint8_t *keep = strip->keep;
#pragma omp simd
    for (uint32_t i = 0; i < n; i++) {
        at[i]++;
        keep[i] = at[i] < end[i];
    }
    p->pack(at, at, keep, n);
    p->pack(end, end, keep, n);
    here->n = p->pack(here->task, here->task, keep, n);
}
//<

//> Compare a point by primitives
INLINED void compare_in(const enum geometry geometry,
                        const struct map *map, struct strip *strip)
{
    gather_compared(map, strip);
    keep_nearer(geometry, map, strip);
    next_point(strip);
}
//<

#define TARGET
#include "ch08-vector-spiral/both_geometries.h"

const struct spiral_kernels spiral_by_primitives[ISA_COUNT] = {
    {PORTABLE, enter_cells, compare_points},
    {AVX2, enter_cells, compare_points},
    {AVX512, enter_cells, compare_points},
};
//<

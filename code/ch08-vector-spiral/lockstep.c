//> Search in lockstep
// The loop over the layers and the one over the cells of a layer; the
// two inner ones are kernels. Lists are packed, what a task remembers
// stays in place. A point costs a constant number of steps where the
// points are scattered evenly.
#include "ch08-vector-spiral/lockstep.h"
#include "ch08-vector-spiral/search_bounds.h"
#include "common/allocate.h"
#include <omp.h>
#include <stdlib.h>

//> Hold what all loops need
struct lockstep {
    const struct map *map;
    const struct spiral_kernels *kernels;
    struct strip *strip;
};
//<

//> Fill whole vectors
static uint32_t lanes_for(uint32_t n)
{
    return (n + LANES_TALLIED - 1) / LANES_TALLIED * LANES_TALLIED;
}
//<

//> Visit a cell in step
static void visit_cells(const struct lockstep *run,
                        const struct tasks *tasks, int32_t dx,
                        int32_t dy)
{
    struct strip *strip = run->strip;
    struct tally *tally = &strip->tally;
    run->kernels->enter_cells(run->map, strip, tasks, dx, dy);
    tally->cell_steps++;
    tally->tried += tasks->n;
    tally->entered += strip->here.n;
    while (strip->here.n > 0) {
        tally->point_rounds++;
        tally->compared += strip->here.n;
        tally->lanes += lanes_for(strip->here.n);
        tally->lanes_unpacked += lanes_for(strip->all.n);
        run->kernels->compare_points(run->map, strip);
    }
}
//<

//> Go round a layer in step
// No further to any side than some task may go.
static int32_t furthest(const struct tasks *tasks, enum side side,
                        int32_t k)
{
    int32_t bound = 0;
    for (uint32_t i = 0; i < tasks->n; i++)
        bound = MAX(bound, tasks->bound[side][i]);
    return MIN(bound, k);
}

static void go_round(const struct lockstep *run,
                     const struct tasks *tasks, int32_t k)
{
    int32_t west = furthest(tasks, WEST, k);
    int32_t east = furthest(tasks, EAST, k);
    int32_t south = furthest(tasks, SOUTH, k);
    int32_t north = furthest(tasks, NORTH, k);
    for (int32_t dy = -south; dy <= north; dy++) {
        if (dy == -k || dy == k) {
            for (int32_t dx = -west; dx <= east; dx++)
                visit_cells(run, tasks, dx, dy);
            continue;
        }
        if (west == k)
            visit_cells(run, tasks, -k, dy);
        if (east == k)
            visit_cells(run, tasks, k, dy);
    }
}
//<

//> Tally a layer
static void do_layer(const struct lockstep *run,
                     const struct tasks *tasks, int32_t k,
                     uint64_t phase[static LAYERS_TALLIED])
{
    struct tally *sum = &run->strip->tally;
    uint64_t before = sum->visited;
    go_round(run, tasks, k);
    if (k < LAYERS_TALLIED) {
        phase[k] += tasks->n;
        sum->of_layer[k] += sum->visited - before;
    }
}
//<

//> Pack a list of tasks
// To strip->layer, which may be the list itself.
static void pack_tasks(struct strip *strip, const struct tasks *from)
{
    const struct primitives *p = strip->primitives;
    const uint8_t *keep = strip->keep;
    struct tasks *to = &strip->layer;
    uint32_t n = from->n;
    strip->tally.listed += n;
    p->pack((uint32_t *)to->column, (uint32_t *)from->column, keep, n);
    p->pack((uint32_t *)to->row, (uint32_t *)from->row, keep, n);
    for (int side = 0; side < SIDES; side++)
        p->pack((uint32_t *)to->bound[side],
                (uint32_t *)from->bound[side], keep, n);
    to->n = p->pack(to->task, from->task, keep, n);
}
//<

//> Seek until every task has a candidate
static void phase_one(const struct lockstep *run)
{
    struct strip *strip = run->strip;
    const uint32_t *nearest = strip->nearest;
    const struct tasks *tasks = &strip->all;
    for (int32_t k = 0; tasks->n > 0; k++) {
        const uint32_t *task = tasks->task, n = tasks->n;
        uint8_t *keep = strip->keep;
        for (uint32_t i = 0; i < n; i++)
            strip->phase_one_layer[task[i]] = k;
        do_layer(run, tasks, k, strip->tally.phase_one);
        for (uint32_t i = 0; i < n; i++)
            keep[i] = nearest[task[i]] == NO_INDEX;
        pack_tasks(strip, tasks);
        tasks = &strip->layer;
    }
}
//<

//> Search the squares
// Layer by layer, the tasks whose square goes so far and that have not
// been there in phase one.
static void phase_two(const struct lockstep *run)
{
    struct strip *strip = run->strip;
    const struct tasks *all = &strip->all;
    const int32_t *west = all->bound[WEST], *east = all->bound[EAST];
    const int32_t *south = all->bound[SOUTH];
    const int32_t *north = all->bound[NORTH],
                  *phase_one_layer = strip->phase_one_layer;
    uint8_t *keep = strip->keep;
    for (int32_t k = 1, last = k; k <= last; k++) {
#pragma omp simd reduction(max : last)
        for (uint32_t t = 0; t < all->n; t++) {
            int32_t far =
                MAX(MAX(west[t], east[t]), MAX(south[t], north[t]));
            keep[t] = (phase_one_layer[t] < k) & (far >= k);
            last = MAX(last, far);
        }
        pack_tasks(strip, all);
        do_layer(run, &strip->layer, k, strip->tally.phase_two);
    }
}
//<

//> Give every point a task
static void begin(const struct lockstep *run, uint32_t first,
                  uint32_t n)
{
    const struct map *map = run->map;
    const struct axis x = map->grid->x, y = map->grid->y;
    struct strip *s = run->strip;
    const struct tasks all = s->all;
    const uint32_t *point = map->cells->point + first;
    s->first = first;
    s->all.n = n;
    s->x[n] = s->y[n] = s->best2[n] = 0;
    s->nearest[n] = 0;
    s->primitives->gather(s->x, map->points.x, point, n);
    s->primitives->gather(s->y, map->points.y, point, n);
    for (uint32_t t = 0; t < n; t++) {
        uint32_t column = axis_cell(&x, s->x[t]);
        uint32_t row = axis_cell(&y, s->y[t]);
        struct search_range wide = whole_range(&x, column);
        struct search_range tall = whole_range(&y, row);
        all.column[t] = column;
        all.row[t] = row;
        all.bound[WEST][t] = wide.back;
        all.bound[EAST][t] = wide.ahead;
        all.bound[SOUTH][t] = tall.back;
        all.bound[NORTH][t] = tall.ahead;
        s->best2[t] = INFINITY;
        s->nearest[t] = NO_INDEX;
    }
}
//<

//> Take a strip through both phases
static void search_strip(const struct lockstep *run, uint32_t first,
                         uint32_t n, struct answers *answers)
{
    struct strip *strip = run->strip;
    const struct primitives *p = strip->primitives;
    const uint32_t *point = run->map->cells->point + first;
    begin(run, first, n);
    phase_one(run);
    bound_searches(run->map, strip);
    phase_two(run);
    p->scatter(answers->nearest2, strip->best2, point, n);
    p->scatter32(answers->nearest, strip->nearest, point, n);
    strip->tally.tasks += n;
}
//<

//> Share out the strips
void search_in_lockstep(const struct question *question,
                        const struct grid *grid,
                        const struct cells *cells,
                        const struct strip_plan *plan,
                        struct answers *answers)
{
    const struct map map = {grid, cells, question->points,
                            question->space};
    const struct spiral_kernels *kernels = plan->kernels;
    const uint32_t n = map.points.n, threads = question->threads;
    const uint32_t length = MIN(plan->length, n);
    struct strip *strips = allocate(threads, sizeof *strips);
    for (uint32_t k = 0; k < threads; k++)
        strips[k] = strip_allocate(primitives(kernels->isa), length);
#pragma omp parallel for num_threads(threads) schedule(dynamic)
    for (uint32_t k = 0; k <= (n - 1) / length; k++) {
        struct lockstep run = {&map, kernels,
                               &strips[omp_get_thread_num()]};
        uint32_t first = k * length;
        search_strip(&run, first, MIN(n - first, length), answers);
    }
    //> Hand over the tallies
    struct tally sum = {0};
    for (uint32_t k = 0; k < threads; k++) {
        tally_add(&sum, &strips[k].tally);
        strip_free(&strips[k]);
    }
    free(strips);
    counts_add(question->counts,
               &(struct counts){.tasks = sum.tasks,
                                .cells = sum.visited,
                                .distances = sum.compared});
    if (plan->tally)
        *plan->tally = sum;
    //<
}
//<
//<

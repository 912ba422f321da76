//> March in step
// See march.h.
#include "ch08-vector-spiral/march.h"
#include "common/clock.h"
#include "common/count.h"
#include "common/fail.h"
#include <omp.h>
#include <stdlib.h>

// What all loops of a strip need.
struct marching {
    const struct map *map;
    const struct loops *loops;
    struct strip *strip;
    struct watch *watch;
};

//> Turn the watch
static void turn(struct watch *watch, enum phase phase)
{
    if (!watch)
        return;
    int64_t now = clock_ns();
    watch->ns[watch->phase] += now - watch->since;
    watch->since = now;
    watch->phase = phase;
    watch->turns[phase]++;
}
//<

//> Fill whole vectors
static uint32_t lanes_for(uint32_t n)
{
    return (n + LANES_TALLIED - 1) / LANES_TALLIED * LANES_TALLIED;
}
//<

//> Look at a cell together
static void look_together(const struct marching *m,
                          const struct tasks *tasks, int32_t dx,
                          int32_t dy)
{
    struct strip *strip = m->strip;
    struct tally *tally = &strip->tally;
    turn(m->watch, IN_CELLS);
    m->loops->enter(m->map, strip, tasks, dx, dy);
    tally->enters++;
    tally->tried += tasks->n;
    tally->entered += strip->here.n;
    turn(m->watch, IN_POINTS);
    while (strip->here.n > 0) {
        tally->looks++;
        tally->points += strip->here.n;
        tally->lanes += lanes_for(strip->here.n);
        tally->unpacked += lanes_for(strip->all.n);
        m->loops->look(m->map, strip);
    }
    turn(m->watch, IN_LAYERS);
}
//<

//> Go round a layer together
// No further to any side than some task may go.
static int32_t furthest(const struct tasks *tasks, enum side side,
                        int32_t k)
{
    int32_t reach = 0;
    for (uint32_t i = 0; i < tasks->n; i++)
        reach = more(reach, tasks->reach[side][i]);
    return fewer(reach, k);
}

static void go_round(const struct marching *m,
                     const struct tasks *tasks, int32_t k)
{
    int32_t west = furthest(tasks, WEST, k);
    int32_t east = furthest(tasks, EAST, k);
    int32_t south = furthest(tasks, SOUTH, k);
    int32_t north = furthest(tasks, NORTH, k);
    for (int32_t dy = -south; dy <= north; dy++) {
        if (dy == -k || dy == k) {
            for (int32_t dx = -west; dx <= east; dx++)
                look_together(m, tasks, dx, dy);
            continue;
        }
        if (west == k)
            look_together(m, tasks, -k, dy);
        if (east == k)
            look_together(m, tasks, k, dy);
    }
}
//<

//> Tally a layer
static void do_layer(const struct marching *m,
                     const struct tasks *tasks, int32_t k,
                     uint64_t tally[static LAYERS_TALLIED])
{
    struct tally *sum = &m->strip->tally;
    uint64_t before = sum->looked;
    go_round(m, tasks, k);
    if (k < LAYERS_TALLIED) {
        tally[k] += tasks->n;
        sum->shown[k] += sum->looked - before;
    }
}
//<

//> Pack a list of tasks
// To strip->some, which may be the list itself.
static void pack_tasks(struct strip *strip, const struct tasks *from)
{
    const struct primitives *p = strip->primitives;
    const uint8_t *keep = strip->keep;
    struct tasks *to = &strip->some;
    uint32_t n = from->n;
    strip->tally.listed += n;
    p->pack((uint32_t *)to->column, (uint32_t *)from->column, keep, n);
    p->pack((uint32_t *)to->row, (uint32_t *)from->row, keep, n);
    for (int side = 0; side < SIDES; side++)
        p->pack((uint32_t *)to->reach[side],
                (uint32_t *)from->reach[side], keep, n);
    to->n = p->pack(to->task, from->task, keep, n);
}
//<

//> Seek until everybody has somebody
static void phase_one(const struct marching *m)
{
    struct strip *strip = m->strip;
    const uint32_t *nearest = strip->nearest;
    const struct tasks *tasks = &strip->all;
    for (int32_t k = 0; tasks->n > 0; k++) {
        const uint32_t *task = tasks->task, n = tasks->n;
        uint8_t *keep = strip->keep;
        for (uint32_t i = 0; i < n; i++)
            strip->ended[task[i]] = k;
        do_layer(m, tasks, k, strip->tally.seeking);
        for (uint32_t i = 0; i < n; i++)
            keep[i] = nearest[task[i]] == NOBODY;
        pack_tasks(strip, tasks);
        tasks = &strip->some;
    }
}
//<

//> Draw a curtain
// Each task goes on to one side, step by step, as long as its square
// does.
INLINED void draw_curtain(const enum geometry geometry,
                          const struct axis axis, struct strip *strip,
                          const int32_t *cell, const double *x,
                          const enum side side)
{
    const bool on = side == EAST || side == NORTH;
    const double *best2 = strip->best2;
    int32_t *reach = strip->all.reach[side];
    uint32_t *going = strip->cell, n = strip->all.n;
    uint8_t *keep = strip->keep;
    for (uint32_t t = 0; t < n; t++)
        going[t] = t;
    for (int32_t steps = 1; n > 0; steps++) {
        strip->tally.steps += n;
        for (uint32_t i = 0; i < n; i++) {
            uint32_t t = going[i];
            struct view all = view_all(&axis, cell[t]);
            double margin = on ? margin_on(geometry, &axis, all,
                                           cell[t], steps, x[t])
                               : margin_back(geometry, &axis, all,
                                             cell[t], steps, x[t]);
            keep[i] = (steps <= (on ? all.on : all.back)) &
                      (margin * margin <= best2[t]);
            reach[t] = steps - 1;
        }
        n = strip->primitives->pack(going, going, keep, n);
    }
}
//<

//> Draw all curtains
static void draw_curtains(const struct marching *m)
{
    const struct grid *grid = m->map->grid;
    struct strip *s = m->strip;
    int32_t *column = s->all.column, *row = s->all.row;
    if (m->map->space.geometry == STANDARD) {
        draw_curtain(STANDARD, grid->x, s, column, s->x, WEST);
        draw_curtain(STANDARD, grid->x, s, column, s->x, EAST);
        draw_curtain(STANDARD, grid->y, s, row, s->y, SOUTH);
        draw_curtain(STANDARD, grid->y, s, row, s->y, NORTH);
    } else {
        draw_curtain(WRAPAROUND, grid->x, s, column, s->x, WEST);
        draw_curtain(WRAPAROUND, grid->x, s, column, s->x, EAST);
        draw_curtain(WRAPAROUND, grid->y, s, row, s->y, SOUTH);
        draw_curtain(WRAPAROUND, grid->y, s, row, s->y, NORTH);
    }
}
//<

//> Look through the squares
// Layer by layer, those whose square goes so far and who have not been
// there in phase one.
static void phase_two(const struct marching *m)
{
    struct strip *strip = m->strip;
    const struct tasks *all = &strip->all;
    const int32_t *west = all->reach[WEST], *east = all->reach[EAST];
    const int32_t *south = all->reach[SOUTH];
    const int32_t *north = all->reach[NORTH], *ended = strip->ended;
    uint8_t *keep = strip->keep;
    for (int32_t k = 1, last = k; k <= last; k++) {
#pragma omp simd reduction(max : last)
        for (uint32_t t = 0; t < all->n; t++) {
            int32_t far =
                more(more(west[t], east[t]), more(south[t], north[t]));
            keep[t] = (ended[t] < k) & (far >= k);
            last = more(last, far);
        }
        pack_tasks(strip, all);
        do_layer(m, &strip->some, k, strip->tally.looking);
    }
}
//<

//> Give every point a task
static void begin(const struct marching *m, uint32_t first, uint32_t n)
{
    const struct map *map = m->map;
    const struct axis x = map->grid->x, y = map->grid->y;
    struct strip *s = m->strip;
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
        struct view wide = view_all(&x, column);
        struct view tall = view_all(&y, row);
        all.column[t] = column;
        all.row[t] = row;
        all.reach[WEST][t] = wide.back;
        all.reach[EAST][t] = wide.on;
        all.reach[SOUTH][t] = tall.back;
        all.reach[NORTH][t] = tall.on;
        s->best2[t] = INFINITY;
        s->nearest[t] = NOBODY;
    }
}
//<

//> March through the layers
static void march_strip(const struct marching *m, uint32_t first,
                        uint32_t n, struct answers *answers)
{
    struct strip *strip = m->strip;
    const uint32_t *point = m->map->cells->point + first;
    begin(m, first, n);
    phase_one(m);
    draw_curtains(m);
    phase_two(m);
    strip->primitives->scatter(answers->nearest2, strip->best2, point,
                               n);
    strip->primitives->scatter32(answers->nearest, strip->nearest,
                                 point, n);
    strip->tally.tasks += n;
}
//<

//> Add up the tallies
// Both are all of 64-bit numbers.
static void add_tally(struct tally *sum, const struct tally *tally)
{
    enum { COUNTERS = sizeof *tally / sizeof(uint64_t) };
    uint64_t *to = (uint64_t *)sum;
    const uint64_t *from = (const uint64_t *)tally;
    for (int k = 0; k < COUNTERS; k++)
        to[k] += from[k];
    COUNT(tasks, tally->tasks);
    COUNT(cells, tally->looked);
    COUNT(distances, tally->points);
}
//<

//> Share out the strips
void march(const struct question *question, const struct grid *grid,
           const struct cells *cells, const struct loops *loops,
           uint32_t length, struct answers *answers,
           struct tally *tally, struct watch *watch)
{
    const struct map map = {grid, cells, question->points,
                            question->space};
    const uint32_t n = map.points.n, threads = question->threads;
    length = length < n ? length : n;
    struct strip *strips = allocate(threads, sizeof *strips);
    for (uint32_t k = 0; k < threads; k++)
        strips[k] = strip_allocate(primitives(loops->isa), length);
#pragma omp parallel for num_threads(threads) schedule(dynamic)
    for (uint32_t strip = 0; strip <= (n - 1) / length; strip++) {
        struct marching m = {&map, loops, &strips[omp_get_thread_num()],
                             watch};
        uint32_t first = strip * length;
        march_strip(&m, first, n - first < length ? n - first : length,
                    answers);
    }
    struct tally sum = {0};
    for (uint32_t k = 0; k < threads; k++) {
        add_tally(&sum, &strips[k].tally);
        strip_free(&strips[k]);
    }
    free(strips);
    if (tally)
        *tally = sum;
}
//<
//<

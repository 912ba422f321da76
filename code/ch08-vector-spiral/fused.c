//> Fuse the loops
// See fused.h.
#include "ch08-vector-spiral/fused.h"
#include "ch08-vector-spiral/fused_avx2.h"
#include <assert.h>
#include <stdlib.h>

//> Enter a cell in one pass
INLINED uint32_t enter_in(const enum geometry geometry,
                          const struct map *map, struct strip *strip,
                          const struct tasks *tasks, int32_t dx,
                          int32_t dy, uint32_t i, uint32_t k)
{
    const struct axis *x = &map->grid->x, *y = &map->grid->y;
    const uint32_t *start = map->cells->start;
    const int32_t *aside = tasks->reach[dx < 0 ? WEST : EAST];
    const int32_t *ahead = tasks->reach[dy < 0 ? SOUTH : NORTH];
    const struct visits *here = &strip->here;
    const int32_t across = abs(dx), along = abs(dy);
    uint64_t looked = 0;
    for (; i < tasks->n; i++) {
        bool seen = (aside[i] >= across) & (ahead[i] >= along);
        int32_t column =
            seen ? go(geometry, x, tasks->column[i], dx) : 0;
        int32_t row = seen ? go(geometry, y, tasks->row[i], dy) : 0;
        uint32_t cell = row * x->count + column;
        here->task[k] = tasks->task[i];
        here->at[k] = start[cell];
        here->end[k] = start[cell + 1];
        looked += seen;
        k += seen & (start[cell] < start[cell + 1]);
    }
    strip->tally.looked += looked;
    return k;
}
//<

//> Look at a point in one pass
INLINED uint32_t look_in(const enum geometry geometry,
                         const struct map *map, struct strip *strip,
                         uint32_t i, uint32_t k)
{
    const struct points p = map->points;
    const uint32_t *point = map->cells->point;
    const struct visits *here = &strip->here;
    double *best2 = strip->best2;
    uint32_t *nearest = strip->nearest;
    for (; i < here->n; i++) {
        uint32_t t = here->task[i], s = here->at[i], end = here->end[i];
        uint32_t j = point[s];
        double d2 = pair2(geometry, map->space, p.x[j] - strip->x[t],
                          p.y[j] - strip->y[t])
                        .near2;
        bool better =
            ((d2 < best2[t]) | ((d2 == best2[t]) & (j < nearest[t]))) &
            (s != strip->first + t);
        best2[t] = better ? d2 : best2[t];
        nearest[t] = better ? j : nearest[t];
        here->task[k] = t;
        here->at[k] = s + 1;
        here->end[k] = end;
        k += s + 1 < end;
    }
    return k;
}
//<

//> Do the rest
uint32_t enter_rest(const struct map *map, struct strip *strip,
                    const struct tasks *tasks, int32_t dx, int32_t dy,
                    uint32_t i, uint32_t k)
{
    if (map->space.geometry == STANDARD)
        return enter_in(STANDARD, map, strip, tasks, dx, dy, i, k);
    return enter_in(WRAPAROUND, map, strip, tasks, dx, dy, i, k);
}

uint32_t look_rest(const struct map *map, struct strip *strip,
                   uint32_t i, uint32_t k)
{
    if (map->space.geometry == STANDARD)
        return look_in(STANDARD, map, strip, i, k);
    return look_in(WRAPAROUND, map, strip, i, k);
}
//<

static void enter(const struct map *map, struct strip *strip,
                  const struct tasks *tasks, int32_t dx, int32_t dy)
{
    strip->here.n = enter_rest(map, strip, tasks, dx, dy, 0, 0);
}

static void look(const struct map *map, struct strip *strip)
{
    strip->here.n = look_rest(map, strip, 0, 0);
}

const struct loops portable_loops = {PORTABLE, enter, look};

struct loops loops_fused(enum isa isa)
{
    assert(isa_present(isa) && "its instructions would be illegal");
#ifdef HAVE_X86_VECTORS
    if (isa >= AVX2)
        return avx2_loops;
#endif
    return portable_loops;
}
//<

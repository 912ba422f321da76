//> Fuse the loops
// See fused.h.
#include "ch08-vector-spiral/fused.h"
#include "ch08-vector-spiral/fused_avx2.h"
#include "ch08-vector-spiral/fused_avx512.h"
#include <assert.h>
#include <stdlib.h>
#include <string.h>

//> Enter a cell in one pass
INLINED void enter_in(const enum geometry geometry,
                      const struct map *map, struct strip *strip,
                      const struct tasks *tasks, int32_t dx, int32_t dy)
{
    const struct axis *x = &map->grid->x, *y = &map->grid->y;
    const uint32_t *start = map->cells->start;
    const int32_t *aside = tasks->reach[dx < 0 ? WEST : EAST];
    const int32_t *ahead = tasks->reach[dy < 0 ? SOUTH : NORTH];
    const struct visits *here = &strip->here;
    const int32_t across = abs(dx), along = abs(dy);
    uint64_t looked = 0;
    uint32_t k = 0;
    for (uint32_t i = 0; i < tasks->n; i++) {
        bool seen = ((aside[i] - across) | (ahead[i] - along)) >= 0;
        uint32_t cell = go(geometry, y, tasks->row[i], dy) * x->count +
                        go(geometry, x, tasks->column[i], dx);
        cell *= seen; // cell 0 is there for all
        uint32_t begin = start[cell], end = start[cell + 1];
        here->task[k] = tasks->task[i];
        here->at[k] = begin;
        here->end[k] = end;
        looked += seen;
        k += seen & (begin < end);
    }
    strip->tally.looked += looked;
    strip->here.n = k;
}
//<

//> Choose between two by their bits
// The first if it is true. Said with ?: it would be for the compiler to
// decide, and it decides for a branch.
static inline double either(bool first, double a, double b)
{
    uint64_t x, y;
    memcpy(&x, &a, sizeof x);
    memcpy(&y, &b, sizeof y);
    y ^= (x ^ y) & -(uint64_t)first;
    memcpy(&b, &y, sizeof b);
    return b;
}
//<

//> Look at a point in one pass
// No number is neither nearer nor as near: a point does not find
// itself.
static const double no_number_if[] = {0, NAN};

INLINED void look_in(const enum geometry geometry,
                     const struct map *map, struct strip *strip)
{
    const struct points p = map->points;
    const uint32_t *point = map->cells->point;
    const struct visits *here = &strip->here;
    double *best2 = strip->best2;
    uint32_t *nearest = strip->nearest;
    uint32_t first = strip->first, k = 0;
    for (uint32_t i = 0; i < here->n; i++) {
        uint32_t t = here->task[i], s = here->at[i], end = here->end[i];
        uint32_t j = point[s];
        double d2 = pair2(geometry, map->space, p.x[j] - strip->x[t],
                          p.y[j] - strip->y[t])
                        .near2;
        d2 += no_number_if[s == first + t];
        double best = best2[t];
        bool better = (d2 < best) | ((d2 == best) & (j < nearest[t]));
        best2[t] = either(better, d2, best);
        nearest[t] ^= (nearest[t] ^ j) & -(uint32_t)better;
        here->task[k] = t;
        here->at[k] = s + 1;
        here->end[k] = end;
        k += s + 1 < end;
    }
    strip->here.n = k;
}
//<

//> Take the copy for the geometry in plain C
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

static const struct loops portable_loops = {PORTABLE, enter, look};
//<

struct loops loops_fused(enum isa isa)
{
    assert(isa_present(isa) && "its instructions would be illegal");
#ifdef HAVE_X86_VECTORS
    if (isa == AVX512)
        return avx512_loops;
    if (isa == AVX2)
        return avx2_loops;
#endif
    return portable_loops;
}
//<

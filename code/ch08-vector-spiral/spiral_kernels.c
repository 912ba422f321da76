//> Fuse the loops
// To enter a cell is one pass over a list of tasks, to compare a point
// one over the visits, in plain C and without branches: what does not
// count is computed as well, and then not kept. Nothing is written
// between the steps of a pass, as it is by primitives.
#include "ch08-vector-spiral/spiral_kernels.h"
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
    const int32_t *bound_x = tasks->bound[dx < 0 ? WEST : EAST];
    const int32_t *bound_y = tasks->bound[dy < 0 ? SOUTH : NORTH];
    const struct visits *here = &strip->here;
    const int32_t steps_x = abs(dx), steps_y = abs(dy);
    uint64_t visited = 0;
    uint32_t k = 0;
    for (uint32_t i = 0; i < tasks->n; i++) {
        //> Enter the cell of one task
        bool within =
            ((bound_x[i] - steps_x) | (bound_y[i] - steps_y)) >= 0;
        uint32_t cell =
            cell_after(geometry, y, tasks->row[i], dy) * x->count +
            cell_after(geometry, x, tasks->column[i], dx);
        cell *= within; // cell 0 is there for all
        uint32_t begin = start[cell], end = start[cell + 1];
        here->task[k] = tasks->task[i];
        here->at[k] = begin;
        here->end[k] = end;
        visited += within;
        k += within & (begin < end);
        //<
    }
    strip->tally.visited += visited;
    strip->here.n = k;
}
//<

//> Choose between two by their bits
// a if `better`, else b. With ?: the compiler decides between a branch
// and a blend, and it decides for a branch.
static inline double either(bool better, double a, double b)
{
    uint64_t x, y;
    memcpy(&x, &a, sizeof x);
    memcpy(&y, &b, sizeof y);
    y ^= (x ^ y) & -(uint64_t)better;
    memcpy(&b, &y, sizeof b);
    return b;
}
//<

//> Compare a point in one pass
// NaN compares as false with everything: a point does not find itself.
static const double nan_if[] = {0, NAN};

INLINED void compare_in(const enum geometry geometry,
                        const struct map *map, struct strip *strip)
{
    const struct points p = map->points;
    const uint32_t *point = map->cells->point;
    const struct visits *here = &strip->here;
    double *best2 = strip->best2;
    uint32_t *nearest = strip->nearest;
    uint32_t first = strip->first, k = 0;
    for (uint32_t i = 0; i < here->n; i++) {
        //> Compare the point of one visit
        uint32_t t = here->task[i], s = here->at[i], end = here->end[i];
        uint32_t j = point[s];
        double d2 = pair2(geometry, map->space, p.x[j] - strip->x[t],
                          p.y[j] - strip->y[t])
                        .near2;
        d2 += nan_if[s == first + t];
        double best = best2[t];
        bool better = (d2 < best) | ((d2 == best) & (j < nearest[t]));
        best2[t] = either(better, d2, best);
        nearest[t] ^= (nearest[t] ^ j) & -(uint32_t)better;
        here->task[k] = t;
        here->at[k] = s + 1;
        here->end[k] = end;
        k += s + 1 < end;
        //<
    }
    strip->here.n = k;
}
//<

#define TARGET
#include "ch08-vector-spiral/both_geometries.h"

const struct spiral_kernels portable_spiral = {PORTABLE, enter_cells,
                                               compare_points};

//> Choose the kernels of the spiral
const struct spiral_kernels *spiral_kernels(enum isa isa)
{
    static const struct spiral_kernels *const tables[ISA_COUNT] =
        FOR_EACH_ISA(&portable_spiral, &avx2_spiral, &avx512_spiral);
    assert(isa_present(isa) && "its instructions would be illegal");
    return tables[isa];
}
//<
//<

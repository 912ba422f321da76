//> Throw away what an octagon encloses
// The furthest points in eight directions, an eighth of a turn apart,
// are the corners of an octagon (Akl and Toussaint 1978 take four). A
// first pass over the points finds them, by stretches that vectors can
// go through; a second one keeps what is not well inside.
#include "ch10-furthest/octagon.h"
#include "common/chunk.h"
#include "common/geometry.h"
#include "common/inlined.h"
#include <math.h>

// AXES directions an eighth of a turn apart, and their opposites.
enum { AXES = EXTREMES / 2, STRETCH = 256, LANES = 8 };

//> Measure along an axis
// To the right; to the right and up; up; to the left and up.
INLINED double along(int axis, double x, double y)
{
    const double right[AXES] = {1, 1, 0, -1}, up[AXES] = {0, 1, 1, 1};
    return right[axis] * x + up[axis] * y;
}
//<

//> Hold the eight extreme points
// One in each direction, counterclockwise: how far out it is, in which
// stretch of the points it was found, and where it is.
struct octagon {
    double extreme[EXTREMES];
    uint32_t stretch[EXTREMES];
    double x[EXTREMES], y[EXTREMES];
};
//<

//> Note an extreme
// Of a tie the lowest stretch, so that threads do not matter.
static void note_extreme(struct octagon *octagon, int e, double extreme,
                         uint32_t stretch)
{
    if (extreme > octagon->extreme[e] ||
        (extreme == octagon->extreme[e] &&
         stretch < octagon->stretch[e])) {
        octagon->extreme[e] = extreme;
        octagon->stretch[e] = stretch;
    }
}
//<

//> Find the extremes of a stretch
// So many points at once; the rest one by one.
INLINED void note_points(const uint32_t lanes, struct points p,
                         uint32_t begin, uint32_t end, uint32_t stretch,
                         struct octagon *octagon)
{
    for (int axis = 0; axis < AXES; axis++) {
        double max[LANES], min[LANES];
        for (uint32_t lane = 0; lane < lanes; lane++)
            max[lane] = -INFINITY, min[lane] = INFINITY;
        for (uint32_t i = begin; i < end; i += lanes)
            for (uint32_t lane = 0; lane < lanes; lane++) {
                double out = along(axis, p.x[i + lane], p.y[i + lane]);
                max[lane] = out > max[lane] ? out : max[lane];
                min[lane] = out < min[lane] ? out : min[lane];
            }
        for (uint32_t lane = 0; lane < lanes; lane++) {
            note_extreme(octagon, axis, max[lane], stretch);
            note_extreme(octagon, AXES + axis, -min[lane], stretch);
        }
    }
}
//<

static uint32_t stretch_end(uint32_t n, uint32_t begin)
{
    return n - begin < STRETCH ? n : begin + STRETCH;
}

//> Find the octagon
static struct octagon octagon_find(struct points p, int threads)
{
    const uint32_t stretches = (p.n - 1) / STRETCH + 1;
    struct octagon octagon;
    for (int e = 0; e < EXTREMES; e++) {
        octagon.extreme[e] = -INFINITY;
        octagon.stretch[e] = UINT32_MAX;
    }
#pragma omp parallel num_threads(threads)
    {
        struct octagon mine = octagon;
#pragma omp for schedule(static)
        for (uint32_t s = 0; s < stretches; s++) {
            //> Note the points of a stretch
            const uint32_t begin = s * STRETCH;
            const uint32_t end = stretch_end(p.n, begin);
            const uint32_t whole = end - (end - begin) % LANES;
            note_points(LANES, p, begin, whole, begin, &mine);
            note_points(1, p, whole, end, begin, &mine);
            //<
        }
#pragma omp critical
        for (int e = 0; e < EXTREMES; e++)
            note_extreme(&octagon, e, mine.extreme[e], mine.stretch[e]);
    }
    //> Look again for the extreme points
    // Any points would do for what follows.
    for (int e = 0; e < EXTREMES; e++) {
        uint32_t i = octagon.stretch[e];
        const uint32_t last = stretch_end(p.n, i) - 1;
        const double sign = e < AXES ? 1 : -1;
        while (i < last && sign * along(e % AXES, p.x[i], p.y[i]) !=
                               octagon.extreme[e])
            i++;
        octagon.x[e] = p.x[i];
        octagon.y[e] = p.y[i];
    }
    //<
    return octagon;
}
//<

//> Find the sides
// No side between two that are the same point. The margin is a length,
// as a share of the box's width and height: its square is 2^-42 of
// theirs, more than the surplus that is asked for (hull.h).
static const double MARGIN = 0x1p-21;

struct sides octagon_sides(struct points points, int threads)
{
    const struct octagon octagon = octagon_find(points, threads);
    const double *x = octagon.x, *y = octagon.y;
    struct sides sides = {.left = -octagon.extreme[AXES],
                          .bottom = -octagon.extreme[AXES + 2]};
    double width = octagon.extreme[0] - sides.left;
    double height = octagon.extreme[2] - sides.bottom;
    sides.diagonal2 = distance2(width, height);
    for (int e = 0; e < EXTREMES; e++) {
        int next = (e + 1) % EXTREMES;
        double a = y[e] - y[next], b = x[next] - x[e];
        double margin = MARGIN * (fabs(a) + fabs(b)) * (width + height);
        sides.a[e] = a;
        sides.b[e] = b;
        sides.c[e] = a * (x[e] - sides.left) +
                     b * (y[e] - sides.bottom) + margin;
        if (a == 0 && b == 0)
            sides.c[e] = -INFINITY;
    }
    return sides;
}
//<

//> Throw away what is inside the octagon
// Writes what is left to kept, and returns how many.
static uint32_t keep_outside(struct points p, uint32_t begin,
                             uint32_t end, const struct sides *given,
                             uint32_t *kept)
{
    const struct sides sides = *given;
    double depth[STRETCH];
    uint32_t count = 0;
    for (uint32_t i = begin; i < end; i++) {
        double x = p.x[i] - sides.left, y = p.y[i] - sides.bottom;
        double min = INFINITY;
#pragma GCC unroll 8
        for (int e = 0; e < EXTREMES; e++) {
            double deep = sides.a[e] * x + sides.b[e] * y - sides.c[e];
            min = deep < min ? deep : min;
        }
        depth[i - begin] = min;
    }
    for (uint32_t i = begin; i < end; i++) {
        kept[count] = i;
        count += !(depth[i - begin] > 0);
    }
    return count;
}
//<

//> Throw away by all threads
// Each keeps its own at the place of its share, until they close up.
uint32_t octagon_outside(struct points p, const struct sides *sides,
                         int threads, struct workspace *workspace,
                         uint32_t *kept)
{
    struct mark mark = workspace_mark(workspace);
    uint32_t *count = workspace_take(workspace, threads, sizeof *count);
    uint32_t total = 0;
#pragma omp parallel for num_threads(threads)
    for (int k = 0; k < threads; k++) {
        uint32_t begin = chunk_begin(p.n, k, threads), next = begin;
        uint32_t end = chunk_begin(p.n, k + 1, threads);
        for (uint64_t i = begin; i < end; i += STRETCH)
            next += keep_outside(p, i, stretch_end(end, i), sides,
                                 kept + next);
        count[k] = next - begin;
    }
    for (int k = 0; k < threads; k++) {
        uint32_t begin = chunk_begin(p.n, k, threads);
        for (uint32_t i = 0; i < count[k]; i++)
            kept[total++] = kept[begin + i];
    }
    workspace_release(workspace, mark);
    return total;
}
//<
//<

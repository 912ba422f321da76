//> Search the corners of the hull
// See hull.h. Why a point p can be left out: let it be a mean of
// others, p = sum of w v with weights w that sum to 1. Then for any q
//     sum of w |v - q|^2 = |p - q|^2 + sum of w |v - p|^2,
// so one of the v is further from q than p, in squared distance by at
// least the last sum, the surplus of p. Squared distances are computed
// with errors below 2^-50 D^2, where D is the diagonal of the box of
// all points. So if the surplus is more than 2^-49 D^2, that v is
// further as computed, too, and p is nobody's furthest. A mean that we
// compute may miss p by 2^-47 D: then 2^-45 D^2 is enough. All this
// where D^2 neither vanishes nor overflows.
#include "ch10-furthest/hull.h"
#include "ch02-all-pairs/pair.h"
#include "ch04-cell-sort/block.h"
#include "ch05-collisions/home.h"
#include "common/clock.h"
#include "common/count.h"
#include "common/fail.h"
#include <stdlib.h>

static const double SURPLUS = 0x1p-44, MISS = 0x1p-48;
static const double LEAST_D2 = 0x1p-900, MOST_D2 = 0x1p+1000;

// AXES directions an eighth of a turn apart, and their opposites.
enum { AXES = 4, EXTREMES = 2 * AXES, STRETCH = 256, LANES = 8 };

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
        double most[LANES], least[LANES];
        for (uint32_t lane = 0; lane < lanes; lane++)
            most[lane] = -INFINITY, least[lane] = INFINITY;
        for (uint32_t i = begin; i < end; i += lanes)
            for (uint32_t lane = 0; lane < lanes; lane++) {
                double out = along(axis, p.x[i + lane], p.y[i + lane]);
                most[lane] = out > most[lane] ? out : most[lane];
                least[lane] = out < least[lane] ? out : least[lane];
            }
        for (uint32_t lane = 0; lane < lanes; lane++) {
            note_extreme(octagon, axis, most[lane], stretch);
            note_extreme(octagon, AXES + axis, -least[lane], stretch);
        }
    }
}

static void note_stretch(struct points p, uint32_t begin, uint32_t end,
                         struct octagon *octagon)
{
    uint32_t whole = end - (end - begin) % LANES;
    note_points(LANES, p, begin, whole, begin, octagon);
    note_points(1, p, whole, end, begin, octagon);
}
//<

static uint32_t stretch_end(uint32_t n, uint32_t begin)
{
    return n - begin < STRETCH ? n : begin + STRETCH;
}

//> Look again for the extreme points
// Any points would do for what follows.
static void look_for_extremes(struct points p, struct octagon *octagon)
{
    for (int e = 0; e < EXTREMES; e++) {
        uint32_t i = octagon->stretch[e];
        const uint32_t last = stretch_end(p.n, i) - 1;
        const double sign = e < AXES ? 1 : -1;
        while (i < last && sign * along(e % AXES, p.x[i], p.y[i]) !=
                               octagon->extreme[e])
            i++;
        octagon->x[e] = p.x[i];
        octagon->y[e] = p.y[i];
    }
}
//<

//> Find the octagon
static struct octagon octagon_find(const struct question *question)
{
    const struct points p = question->points;
    const uint32_t stretches = (p.n - 1) / STRETCH + 1;
    struct octagon octagon;
    for (int e = 0; e < EXTREMES; e++) {
        octagon.extreme[e] = -INFINITY;
        octagon.stretch[e] = UINT32_MAX;
    }
#pragma omp parallel num_threads(question->threads)
    {
        struct octagon mine = octagon;
#pragma omp for schedule(static)
        for (uint32_t s = 0; s < stretches; s++)
            note_stretch(p, s * STRETCH, stretch_end(p.n, s * STRETCH),
                         &mine);
#pragma omp critical
        for (int e = 0; e < EXTREMES; e++)
            note_extreme(&octagon, e, mine.extreme[e], mine.stretch[e]);
    }
    look_for_extremes(p, &octagon);
    return octagon;
}
//<

//> Hold the sides of the octagon
// A point at (x, y) from the low corner of the box lies deeper inside
// than the margin if a x + b y > c for all eight. Then its surplus is
// the square of the margin at least: it is the middle between two
// points of the octagon that are as far away as that.
struct sides {
    double left, bottom, diagonal2;
    double a[EXTREMES], b[EXTREMES], c[EXTREMES];
};

static const double MARGIN = 0x1p-21;

static struct sides sides_of(const struct octagon *octagon)
{
    const double *x = octagon->x, *y = octagon->y;
    struct sides sides = {.left = -octagon->extreme[AXES],
                          .bottom = -octagon->extreme[AXES + 2]};
    double width = octagon->extreme[0] - sides.left;
    double height = octagon->extreme[2] - sides.bottom;
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
            sides.c[e] = -INFINITY; // no side
    }
    return sides;
}
//<

//> Throw away what is inside the octagon
// Writes who is left to kept, and returns how many.
static uint32_t keep_outside(struct points p, uint32_t begin,
                             uint32_t end, const struct sides *given,
                             uint32_t *kept)
{
    const struct sides sides = *given;
    double depth[STRETCH];
    uint32_t count = 0;
    for (uint32_t i = begin; i < end; i++) {
        double x = p.x[i] - sides.left, y = p.y[i] - sides.bottom;
        double least = INFINITY;
#pragma GCC unroll 8
        for (int e = 0; e < EXTREMES; e++) {
            double deep = sides.a[e] * x + sides.b[e] * y - sides.c[e];
            least = deep < least ? deep : least;
        }
        depth[i - begin] = least;
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
static uint32_t keep_by_shares(const struct question *question,
                               const struct sides *sides,
                               uint32_t *kept)
{
    const struct points p = question->points;
    const int shares = question->threads;
    uint32_t *count = allocate(shares, sizeof *count), total = 0;
#pragma omp parallel for num_threads(shares)
    for (int k = 0; k < shares; k++) {
        uint32_t begin = share_begin(p.n, k, shares), next = begin;
        uint32_t end = share_begin(p.n, k + 1, shares);
        for (uint64_t i = begin; i < end; i += STRETCH)
            next += keep_outside(p, i, stretch_end(end, i), sides,
                                 kept + next);
        count[k] = next - begin;
    }
    for (int k = 0; k < shares; k++) {
        uint32_t begin = share_begin(p.n, k, shares);
        for (uint32_t i = 0; i < count[k]; i++)
            kept[total++] = kept[begin + i];
    }
    free(count);
    return total;
}
//<

struct candidate {
    double x, y;
    uint32_t point;
};

//> Sort the candidates
// From left to right, of the same x from below; of several in the same
// place the one of the lowest index stays.
static int from_left(const void *one, const void *other)
{
    const struct candidate *a = one, *b = other;
    if (a->x != b->x)
        return a->x < b->x ? -1 : 1;
    if (a->y != b->y)
        return a->y < b->y ? -1 : 1;
    return (a->point > b->point) - (a->point < b->point);
}

static uint32_t sort_candidates(struct candidate *candidate, uint32_t n)
{
    uint32_t count = 1;
    qsort(candidate, n, sizeof *candidate, from_left);
    for (uint32_t k = 1; k < n; k++)
        if (candidate[k].x != candidate[count - 1].x ||
            candidate[k].y != candidate[count - 1].y)
            candidate[count++] = candidate[k];
    return count;
}
//<

//> Chain those below, or above
// From the leftmost to the rightmost, turning left all the way if sign
// is 1, right if it is -1. Writes the corners, and returns how many.
static double turn(struct candidate a, struct candidate b,
                   struct candidate c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

static uint32_t chain_up(const struct candidate *candidate, uint32_t n,
                         double sign, struct candidate *corner)
{
    uint32_t count = 0;
    for (uint32_t k = 0; k < n; k++) {
        while (count >= 2 &&
               sign * turn(corner[count - 2], corner[count - 1],
                           candidate[k]) <=
                   0)
            count--;
        corner[count++] = candidate[k];
    }
    return count;
}
//<

//> Stand on a side
// The point of the side from a to b right below or above p: how far
// above p it is, and its own surplus. Of an upright side, the end.
struct foot {
    double rise, surplus;
};

static struct foot foot_on(struct candidate a, struct candidate b,
                           struct candidate p, double end)
{
    double t = b.x > a.x ? (p.x - a.x) / (b.x - a.x) : end;
    return (struct foot){(a.y - p.y) + t * (b.y - a.y),
                         t * (1 - t) * distance2(b.x - a.x, b.y - a.y)};
}
//<

//> Decide whether a point can be left out
// It lies between a foot on the lower chain and one on the upper. If it
// misses both by rounding, one of them is near enough.
static bool can_be_left_out(struct foot low, struct foot high,
                            double diagonal2)
{
    double miss = MISS * sqrt(diagonal2);
    double gap = high.rise - low.rise;
    double w = gap > 0 ? least(1, most(0, -low.rise / gap)) : 0;
    return low.rise <= miss && high.rise >= -miss &&
           (1 - w) * low.surplus + w * high.surplus +
                   w * (1 - w) * gap * gap >
               SURPLUS * diagonal2;
}
//<

//> Leave out all that can be
// Ends up with the candidates that stay, and returns how many.
static uint32_t leave_out(struct candidate *candidate, uint32_t n,
                          const struct candidate *lower,
                          const struct candidate *upper,
                          double diagonal2)
{
    uint32_t count = 0;
    for (uint32_t k = 0; k < n; k++) {
        struct candidate p = candidate[k];
        while (lower[1].x < p.x)
            lower++;
        while (upper[1].x < p.x)
            upper++;
        if (!can_be_left_out(foot_on(lower[0], lower[1], p, 0),
                             foot_on(upper[0], upper[1], p, 1),
                             diagonal2))
            candidate[count++] = p;
    }
    return count;
}
//<

//> Find the corners among the candidates
static uint32_t keep_corners(struct candidate *candidate, uint32_t n,
                             double diagonal2)
{
    struct candidate *lower = allocate(n, sizeof *lower);
    struct candidate *upper = allocate(n, sizeof *upper);
    n = sort_candidates(candidate, n);
    chain_up(candidate, n, 1, lower);
    chain_up(candidate, n, -1, upper);
    n = leave_out(candidate, n, lower, upper, diagonal2);
    free(upper);
    free(lower);
    return n;
}
//<

//> Put the corners in the order of the points
static int by_index(const void *one, const void *other)
{
    const struct candidate *a = one, *b = other;
    return (a->point > b->point) - (a->point < b->point);
}

static struct corners corners_from(struct candidate *candidate,
                                   uint32_t n)
{
    struct corners corners = {points_allocate(n),
                              allocate(n, sizeof *corners.point)};
    qsort(candidate, n, sizeof *candidate, by_index);
    for (uint32_t k = 0; k < n; k++) {
        corners.points.x[k] = candidate[k].x;
        corners.points.y[k] = candidate[k].y;
        corners.point[k] = candidate[k].point;
    }
    return corners;
}
//<

//> Find the corners
// If all squared distances vanish, everybody's furthest is the first
// point, whose own is the second: search_corners begins with that, and
// one corner is enough.
struct corners corners_find(const struct question *question)
{
    const struct points p = question->points;
    const struct octagon octagon = octagon_find(question);
    const struct sides sides = sides_of(&octagon);
    const double diagonal2 = sides.diagonal2;
    bool trusted = diagonal2 > LEAST_D2 && diagonal2 < MOST_D2;
    uint32_t *kept = allocate(p.n, sizeof *kept);
    uint32_t count = diagonal2 > 0 ? p.n : 1;
    if (trusted)
        count = keep_by_shares(question, &sides, kept);
    struct candidate *candidate = allocate(count, sizeof *candidate);
    for (uint32_t k = 0; k < count; k++) {
        uint32_t i = trusted ? kept[k] : k;
        candidate[k] = (struct candidate){p.x[i], p.y[i], i};
    }
    if (trusted)
        count = keep_corners(candidate, count, diagonal2);
    struct corners corners = corners_from(candidate, count);
    free(candidate);
    free(kept);
    return corners;
}

void corners_free(struct corners *corners)
{
    points_free(&corners->points);
    free(corners->point);
    *corners = (struct corners){0};
}
//<

//> Let eight ask every corner
// Nobody is further from himself than 0, so all may ask about all.
enum { ASKING = LANES, NOBODY = -1 };

static void ask_corners(const struct corners *corners, const double *x,
                        const double *y, double *furthest2,
                        int64_t *furthest)
{
    const uint32_t n = corners->points.n;
    double most2[ASKING] = {0};
    int64_t corner[ASKING];
    for (int lane = 0; lane < ASKING; lane++)
        corner[lane] = NOBODY;
    for (uint32_t k = 0; k < n; k++)
        for (int lane = 0; lane < ASKING; lane++) {
            double far2 = distance2(corners->points.x[k] - x[lane],
                                    corners->points.y[k] - y[lane]);
            bool further = far2 > most2[lane];
            most2[lane] = further ? far2 : most2[lane];
            corner[lane] = further ? k : corner[lane];
        }
    for (int lane = 0; lane < ASKING; lane++) {
        furthest2[lane] = most2[lane];
        furthest[lane] = corner[lane];
    }
}
//<

//> Answer eight questions
static void answer_eight(const struct question *question,
                         const struct corners *corners, uint32_t begin,
                         struct answers *answers)
{
    const struct points p = question->points;
    const uint32_t left = p.n - begin;
    const uint32_t asking = left < ASKING ? left : ASKING;
    double x[ASKING], y[ASKING], furthest2[ASKING];
    int64_t furthest[ASKING];
    for (uint32_t lane = 0; lane < ASKING; lane++) {
        uint32_t i = begin + (lane < asking ? lane : 0);
        x[lane] = p.x[i];
        y[lane] = p.y[i];
    }
    ask_corners(corners, x, y, furthest2, furthest);
    for (uint32_t lane = 0; lane < asking; lane++) {
        uint32_t i = begin + lane;
        answers->furthest2[i] = furthest2[lane];
        answers->furthest[i] = furthest[lane] == NOBODY
                                   ? i == 0
                                   : corners->point[furthest[lane]];
    }
}
//<

//> Share out the questions to the corners
void search_corners(const struct question *question,
                    const struct corners *corners,
                    struct answers *answers)
{
    const uint32_t n = question->points.n;
#pragma omp parallel for num_threads(question->threads) schedule(static)
    for (uint64_t begin = 0; begin < n; begin += ASKING)
        answer_eight(question, corners, begin, answers);
    COUNT(distances, (uint64_t)n * corners->points.n);
}

void furthest_hull(const struct question *question,
                   struct answers *answers)
{
    struct corners corners = corners_find(question);
    answers->built_ns = clock_ns();
    search_corners(question, &corners, answers);
    corners_free(&corners);
}
//<
//<

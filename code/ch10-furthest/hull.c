//> Find the corners of the hull
// What an octagon leaves over is sorted from left to right; a chain
// turns left below it and right above it (Andrew 1979). What lies well
// inside of both, by more than distances are rounded, is left out: no
// exact predicate decides. n log n steps, n the points left over.
#include "ch10-furthest/hull.h"
#include "ch10-furthest/candidates.h"
#include "ch10-furthest/octagon.h"
#include "ch10-furthest/sort_keys.h"
#include "common/min_max.h"
#include <stdbool.h>

//> Allow for a miss
// How far above or below a point its foot may lie, as a share of the
// diagonal. With the rounding of the feet, far less, a mean that we
// compute then misses its point by less than twice that, 2^-47.
static const double MISS = 0x1p-48;
//<

//> Say which way three points turn
// Left if it is positive, right if it is negative.
static double orientation(struct candidate a, struct candidate b,
                          struct candidate c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}
//<

//> Chain those below, or above
// From the leftmost to the rightmost, turning left all the way if sign
// is 1, right if it is -1. Writes the corners, and returns how many.
static uint32_t monotone_chain(const struct candidate *candidate,
                               uint32_t n, double sign,
                               struct candidate *corner)
{
    uint32_t count = 0;
    for (uint32_t k = 0; k < n; k++) {
        while (count >= 2 &&
               sign * orientation(corner[count - 2], corner[count - 1],
                                  candidate[k]) <=
                   0)
            count--;
        corner[count++] = candidate[k];
    }
    return count;
}
//<

//> Find the foot on a side
// The foot of p is the point of the side from a to b that is right
// below or above p: its rise is how far above. If the side is upright,
// it is a where end is 0, b where end is 1.
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
// If p is a mean of others, p = sum of w v with weights w that sum to
// 1, one of them is further than p from everywhere, in squared distance
// by at least the surplus of p, the sum of w |v - p|^2. Here p lies
// between a foot on the lower chain and one on the upper, each a mean
// of two. If rounding has put it outside of both, the nearer foot
// stands for it.
static bool can_be_left_out(struct foot low, struct foot high,
                            double diagonal2)
{
    double miss = MISS * sqrt(diagonal2);
    double gap = high.rise - low.rise;
    double w = gap > 0 ? MIN(1, MAX(0, -low.rise / gap)) : 0;
    return low.rise <= miss && high.rise >= -miss &&
           (1 - w) * low.surplus + w * high.surplus +
                   w * (1 - w) * gap * gap >
               CORNER_SURPLUS * diagonal2;
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

//> Put the corners in the order of the points
static struct corners corners_from(const struct candidate *candidate,
                                   uint32_t n,
                                   struct workspace *workspace)
{
    struct corners corners = corners_take(n, workspace);
    for (uint32_t k = 0; k < n; k++) {
        corners.points.x[k] = candidate[k].x;
        corners.points.y[k] = candidate[k].y;
        corners.point[k] = candidate[k].point;
    }
    return corners;
}

struct corners corners_by_index(struct corners corners,
                                struct workspace *workspace)
{
    const uint32_t n = corners.points.n;
    struct corners ordered = corners_take(n, workspace);
    struct mark mark = workspace_mark(workspace);
    struct keyed *key = workspace_take(workspace, n, sizeof *key);
    struct keyed *sorted = workspace_take(workspace, n, sizeof *sorted);
    for (uint32_t k = 0; k < n; k++)
        key[k] = (struct keyed){corners.point[k], k};
    sort_keys(key, n, sorted, workspace);
    for (uint32_t k = 0; k < n; k++) {
        const uint32_t from = sorted[k].number;
        ordered.points.x[k] = corners.points.x[from];
        ordered.points.y[k] = corners.points.y[from];
        ordered.point[k] = corners.point[from];
    }
    workspace_release(workspace, mark);
    return ordered;
}
//<

struct corners corners_take(uint32_t n, struct workspace *workspace)
{
    return (struct corners){
        {n, workspace_take(workspace, n, sizeof(double)),
         workspace_take(workspace, n, sizeof(double))},
        workspace_take(workspace, n, sizeof(uint32_t))};
}

//> Find the corners
// If all squared distances vanish, the furthest of every point is the
// first, and of the first the second: search_corners begins with that,
// and one corner is enough.
struct corners corners_from_left(struct corners among, int threads,
                                 struct workspace *workspace)
{
    const struct points p = among.points;
    const struct sides sides = octagon_sides(p, threads);
    const double diagonal2 = sides.diagonal2;
    bool trusted = diagonal2 > MIN_D2 && diagonal2 < MAX_D2;
    uint32_t *kept = workspace_take(workspace, p.n, sizeof *kept);
    uint32_t count = diagonal2 > 0 ? p.n : 1;
    if (trusted)
        count = octagon_outside(p, &sides, threads, workspace, kept);
    struct candidate *candidate =
        workspace_take(workspace, count, sizeof *candidate);
    for (uint32_t k = 0; k < count; k++) {
        uint32_t i = trusted ? kept[k] : k;
        candidate[k] = (struct candidate){
            p.x[i], p.y[i], among.point ? among.point[i] : i};
    }
    if (trusted) {
        //> Find the corners among the candidates
        struct mark mark = workspace_mark(workspace);
        struct candidate *lower =
            workspace_take(workspace, count, sizeof *lower);
        struct candidate *upper =
            workspace_take(workspace, count, sizeof *upper);
        count = sort_candidates(candidate, count, workspace);
        monotone_chain(candidate, count, 1, lower);
        monotone_chain(candidate, count, -1, upper);
        count = leave_out(candidate, count, lower, upper, diagonal2);
        workspace_release(workspace, mark);
        //<
    }
    return corners_from(candidate, count, workspace);
}
//<

//> Find the corners by index
struct corners corners_among(struct corners points, int threads,
                             struct workspace *workspace)
{
    return corners_by_index(
        corners_from_left(points, threads, workspace), workspace);
}

struct corners corners_find(const struct question *question,
                            struct workspace *workspace)
{
    return corners_among((struct corners){question->points, NULL},
                         question->threads, workspace);
}
//<
//<

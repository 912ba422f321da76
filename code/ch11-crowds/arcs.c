//> Make the tree of arcs
// Sort the corners by angle, in buckets; then describe every arc: where
// the center of its circle is, and what box it fits in, seen from there
// and turned to lie along it. h log h steps for h corners.
#include "ch11-crowds/arcs.h"
#include "ch04-cell-sort/cells.h"
#include "common/min_max.h"
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

//> Put the corners in a round
//> Measure a bearing
// By an angle that needs no arc tangent.
struct bearing {
    double angle;
    uint32_t corner;
};

static double bearing_of(double dx, double dy)
{
    const double sum = fabs(dx) + fabs(dy);
    return sum > 0 ? copysign(1 - dx / sum, dy) : 0; // -2 to 2
}
//<

static int by_angle(const void *one, const void *other)
{
    const struct bearing *a = one, *b = other;
    if (a->angle != b->angle)
        return a->angle < b->angle ? -1 : 1;
    return (a->corner > b->corner) - (a->corner < b->corner);
}

static struct box box_around(struct points p)
{
    struct box box = {INFINITY, -INFINITY, INFINITY, -INFINITY};
    for (uint32_t k = 0; k < p.n; k++) {
        box.left = MIN(p.x[k], box.left);
        box.right = MAX(p.x[k], box.right);
        box.bottom = MIN(p.y[k], box.bottom);
        box.top = MAX(p.y[k], box.top);
    }
    return box;
}

//> Sort the corners by bearing
// As many buckets as corners, mostly with one each; where they crowd, a
// bucket is sorted.
static void sort_by_angle(struct bearing *bearing, uint32_t n,
                          struct bearing *sorted, uint32_t *end)
{
    const double scale = n / 4.0;
    memset(end, 0, (n + 1) * sizeof *end);
    for (uint32_t k = 0; k < n; k++)
        end[(uint32_t)((bearing[k].angle + 2) * scale)]++;
    cells_scan(end, n + 1, 0);
    for (uint32_t k = 0; k < n; k++)
        sorted[end[(uint32_t)((bearing[k].angle + 2) * scale)]++] =
            bearing[k];
    for (uint32_t b = 0, begin = 0; b <= n; begin = end[b++])
        if (end[b] - begin > 1)
            qsort(sorted + begin, end[b] - begin, sizeof *sorted,
                  by_angle);
}
//<

static void go_round(const struct corners *corners,
                     const struct box *box, struct arcs *arcs,
                     struct workspace *workspace)
{
    const struct points p = corners->points;
    const double x = box->left / 2 + box->right / 2;
    const double y = box->bottom / 2 + box->top / 2;
    struct mark mark = workspace_mark(workspace);
    struct bearing *bearing =
        workspace_take(workspace, p.n, sizeof *bearing);
    struct bearing *sorted =
        workspace_take(workspace, p.n, sizeof *sorted);
    uint32_t *end =
        workspace_take(workspace, (size_t)p.n + 1, sizeof *end);
    for (uint32_t k = 0; k < p.n; k++)
        bearing[k] =
            (struct bearing){bearing_of(p.x[k] - x, p.y[k] - y), k};
    sort_by_angle(bearing, p.n, sorted, end);
    for (uint32_t k = 0; k < p.n; k++) {
        const uint32_t corner = sorted[k].corner;
        arcs->points.x[k] = p.x[corner];
        arcs->points.y[k] = p.y[corner];
        arcs->point[k] = corners->point[corner];
    }
    workspace_release(workspace, mark);
}
//<

//> Find the center of an arc
// Of the circle through its first, middle and last corner, seen from
// the middle one; no further away than a few diameters of everything,
// so that rounding stays small.
static void center_of(struct points p, double diameter, double *x,
                      double *y)
{
    const uint32_t m = p.n / 2, last = p.n - 1;
    const double ax = p.x[0] - p.x[m], ay = p.y[0] - p.y[m];
    const double bx = p.x[last] - p.x[m], by = p.y[last] - p.y[m];
    const double a2 = distance2(ax, ay), b2 = distance2(bx, by);
    const double twice = 2 * (ax * by - ay * bx);
    double u = (by * a2 - ay * b2) / twice;
    double v = (ax * b2 - bx * a2) / twice;
    const double length = sqrt(distance2(u, v));
    const double most = 4 * diameter;
    if (!isfinite(length) || !(length > 0))
        u = v = 0;
    else if (length > most)
        u *= most / length, v *= most / length;
    *x = p.x[m] + u;
    *y = p.y[m] + v;
}
//<

//> Describe an arc
//> Direct an arc
static void direct(struct points p, struct arc *arc)
{
    const double dx = p.x[p.n - 1] - p.x[0];
    const double dy = p.y[p.n - 1] - p.y[0];
    const double length = sqrt(distance2(dx, dy));
    arc->tx = length > 0 ? dx / length : 1;
    arc->ty = length > 0 ? dy / length : 0;
}
//<

static struct arc describe(struct points p, const uint32_t *point,
                           double diameter)
{
    struct arc arc = {.box = box_around(p),
                      .along = {INFINITY, -INFINITY},
                      .beside = {INFINITY, -INFINITY},
                      .lowest = NO_INDEX};
    center_of(p, diameter, &arc.ox, &arc.oy);
    direct(p, &arc);
    for (uint32_t k = 0; k < p.n; k++) {
        const double vx = p.x[k] - arc.ox, vy = p.y[k] - arc.oy;
        const double along = vx * arc.tx + vy * arc.ty;
        const double beside = vy * arc.tx - vx * arc.ty;
        arc.along[0] = MIN(along, arc.along[0]);
        arc.along[1] = MAX(along, arc.along[1]);
        arc.beside[0] = MIN(beside, arc.beside[0]);
        arc.beside[1] = MAX(beside, arc.beside[1]);
        arc.max2 = MAX(distance2(vx, vy), arc.max2);
        arc.lowest = MIN(point[k], arc.lowest);
    }
    const double most = sqrt(arc.max2) + diameter;
    arc.margin = most * most * 0x1p-45;
    return arc;
}
//<

//> Make an arc for every stretch
// The corners of arc k, which is in this level of the tree.
static struct points corners_of(const struct arcs *arcs, uint32_t k,
                                uint32_t *begin)
{
    uint32_t width = PER_ARC * arcs->leaves, first = 0;
    while (k - first >= first + 1)
        first = 2 * first + 1, width /= 2;
    const uint64_t from = (uint64_t)(k - first) * width;
    const uint32_t n = arcs->points.n;
    *begin = MIN(from, n);
    return (struct points){MIN(n - *begin, width),
                           arcs->points.x + *begin,
                           arcs->points.y + *begin};
}

struct arcs arcs_make(const struct corners *corners,
                      struct workspace *workspace)
{
    const uint32_t n = corners->points.n;
    struct arcs arcs = {{n,
                         workspace_take(workspace, n, sizeof(double)),
                         workspace_take(workspace, n, sizeof(double))},
                        workspace_take(workspace, n, sizeof(uint32_t)),
                        NULL,
                        1};
    while ((uint64_t)arcs.leaves * PER_ARC < n)
        arcs.leaves *= 2;
    arcs.arc = workspace_take(workspace, 2 * (size_t)arcs.leaves - 1,
                              sizeof *arcs.arc);
    const struct box box = box_around(corners->points);
    const double diameter =
        sqrt(distance2(box.right - box.left, box.top - box.bottom));
    go_round(corners, &box, &arcs, workspace);
    for (uint32_t k = 0; k < 2 * arcs.leaves - 1; k++) {
        uint32_t begin;
        const struct points p = corners_of(&arcs, k, &begin);
        if (p.n > 0)
            arcs.arc[k] = describe(p, arcs.point + begin, diameter);
        else
            arcs.arc[k] = (struct arc){.max2 = -INFINITY};
    }
    return arcs;
}
//<
//<

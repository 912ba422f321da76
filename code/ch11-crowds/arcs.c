//> Make the tree of arcs
// Sort the corners by angle; then describe every arc: where the center
// of its circle is, and what box it fits in, seen from there and turned
// to lie along it. h log h steps for h corners.
#include "ch11-crowds/arcs.h"
#include "ch04-cell-sort/grid.h"
#include "ch10-furthest/sort_keys.h"
#include "common/min_max.h"
#include <math.h>
#include <string.h>

//> Put the corners in a round
//> Find a pseudoangle
// It grows with the angle, and needs no arc tangent.
static double pseudoangle(double dx, double dy)
{
    const double sum = fabs(dx) + fabs(dy);
    return sum > 0 ? copysign(1 - dx / sum, dy) : 0; // -2 to 2
}
//<

struct box box_around(struct points p)
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

static void go_round(const struct corners *corners,
                     const struct box *box, struct arcs *arcs,
                     struct workspace *workspace)
{
    const struct points p = corners->points;
    const double x = box->left / 2 + box->right / 2;
    const double y = box->bottom / 2 + box->top / 2;
    struct mark mark = workspace_mark(workspace);
    struct keyed *angle = workspace_take(workspace, p.n, sizeof *angle);
    struct keyed *sorted =
        workspace_take(workspace, p.n, sizeof *sorted);
    for (uint32_t k = 0; k < p.n; k++)
        angle[k] =
            (struct keyed){pseudoangle(p.x[k] - x, p.y[k] - y), k};
    sort_keys(angle, p.n, sorted, workspace);
    for (uint32_t k = 0; k < arcs->padded_n; k++) {
        const uint32_t corner = sorted[MIN(k, p.n - 1)].number;
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
    const double max_length = 4 * diameter;
    if (!isfinite(length) || !(length > 0))
        u = v = 0;
    else if (length > max_length)
        u *= max_length / length, v *= max_length / length;
    *x = p.x[m] + u;
    *y = p.y[m] + v;
}
//<

//> Describe an arc
//> Direct an arc
static void direct(struct points p, double *tx, double *ty)
{
    const double dx = p.x[p.n - 1] - p.x[0];
    const double dy = p.y[p.n - 1] - p.y[0];
    const double length = sqrt(distance2(dx, dy));
    *tx = length > 0 ? dx / length : 1;
    *ty = length > 0 ? dy / length : 0;
}
//<

// As arc k of a node. What rounding may do to the bound is added once.
static void describe(struct points p, double diameter,
                     struct arc_node *node, int k)
{
    const struct box box = box_around(p);
    double ox, oy, tx, ty, max2 = 0;
    struct extent along = {INFINITY, -INFINITY}, beside = along;
    center_of(p, diameter, &ox, &oy);
    direct(p, &tx, &ty);
    for (uint32_t c = 0; c < p.n; c++) {
        const double vx = p.x[c] - ox, vy = p.y[c] - oy;
        const double a = vx * tx + vy * ty, b = vy * tx - vx * ty;
        along = (struct extent){MIN(a, along.low), MAX(a, along.high)};
        beside =
            (struct extent){MIN(b, beside.low), MAX(b, beside.high)};
        max2 = MAX(distance2(vx, vy), max2);
    }
    const double longest = sqrt(max2) + diameter;
    node->left[k] = box.left, node->right[k] = box.right;
    node->bottom[k] = box.bottom, node->top[k] = box.top;
    node->ox[k] = ox, node->oy[k] = oy;
    node->tx[k] = tx, node->ty[k] = ty;
    node->max2[k] = max2 + longest * longest * 0x1p-45;
    node->along[0][k] = along.low, node->along[1][k] = along.high;
    node->beside[0][k] = beside.low, node->beside[1][k] = beside.high;
}
//<

//> Make the nodes of a level
// The arcs have so many corners each, but for the last one.
static void make_level(const struct arcs *arcs, uint64_t width,
                       struct arc_node *node, uint32_t count)
{
    const struct points all = arcs->points;
    for (uint32_t arc = 0; arc < count * FANOUT; arc++) {
        struct arc_node *of = &node[arc / FANOUT];
        const int k = arc % FANOUT;
        const uint32_t begin = MIN(arc * width, all.n);
        const uint32_t end = MIN((arc + 1) * width, all.n);
        of->max2[k] = -INFINITY;
        of->lowest[k] = NO_INDEX;
        if (begin < end)
            describe((struct points){end - begin, all.x + begin,
                                     all.y + begin},
                     arcs->diameter, of, k);
        for (uint32_t c = begin; c < end; c++)
            of->lowest[k] = MIN(arcs->point[c], of->lowest[k]);
    }
}
//<

//> Make all levels
static void make_levels(struct arcs *arcs, struct workspace *workspace)
{
    uint32_t arcs_there = arcs->padded_n / PER_ARC;
    uint64_t width = PER_ARC;
    do {
        const uint32_t nodes = (arcs_there - 1) / FANOUT + 1;
        struct arc_node *level =
            workspace_take(workspace, nodes, sizeof *level);
        memset(level, 0, nodes * sizeof *level);
        make_level(arcs, width, level, nodes);
        arcs->level[arcs->levels++] = level;
        arcs_there = nodes;
        width *= FANOUT;
    } while (arcs_there > 1);
}
//<

struct arcs arcs_make(const struct corners *corners,
                      struct workspace *workspace)
{
    const uint32_t n = corners->points.n;
    const size_t padded_n =
        ((size_t)n + PER_ARC - 1) / PER_ARC * PER_ARC;
    struct arcs arcs = {
        .points = {n,
                   workspace_take(workspace, padded_n, sizeof(double)),
                   workspace_take(workspace, padded_n, sizeof(double))},
        .point = workspace_take(workspace, padded_n, sizeof(uint32_t)),
        .padded_n = padded_n};
    const struct box box = box_around(corners->points);
    arcs.diameter =
        sqrt(distance2(box.right - box.left, box.top - box.bottom));
    go_round(corners, &box, &arcs, workspace);
    make_levels(&arcs, workspace);
    return arcs;
}
//<

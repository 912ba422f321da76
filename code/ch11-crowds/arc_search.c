//> Search the tree of arcs
// With v = c - o and g = o - q, a corner c is at the squared distance
// |g|^2 + |v|^2 + 2 g v from the query q. The first term is known, the
// second is the same for all corners if o is the center of the arc's
// circle, and the third is at most what the arc's turned box allows.
#include "ch11-crowds/arcs.h"
#include "common/min_max.h"
#include <stdbool.h>

//> Bound an arc
// The less of two bounds: that of its box, and that of its bend.
static double arc_bound(const struct arc *arc, double x, double y)
{
    const double gx = arc->ox - x, gy = arc->oy - y;
    const double along = gx * arc->tx + gy * arc->ty;
    const double beside = gy * arc->tx - gx * arc->ty;
    const double bent2 =
        distance2(gx, gy) + arc->max2 +
        2 * (MAX(along * arc->along[0], along * arc->along[1]) +
             MAX(beside * arc->beside[0], beside * arc->beside[1])) +
        arc->margin;
    const double box2 =
        distance2(MAX(x - arc->box.left, arc->box.right - x),
                  MAX(y - arc->box.bottom, arc->box.top - y));
    return MIN(bent2, box2);
}
//<

//> Compare with the corners of an arc
static void compare_corner(const struct arcs *arcs, uint32_t k,
                           struct arc_query *query)
{
    const double far2 = distance2(arcs->points.x[k] - query->x,
                                  arcs->points.y[k] - query->y);
    if (far2 > query->max2 ||
        (far2 == query->max2 && arcs->point[k] < query->furthest)) {
        query->max2 = far2;
        query->furthest = arcs->point[k];
        query->corner = k;
    }
    query->compared++;
}

static void compare_leaf(const struct arcs *arcs, uint32_t leaf,
                         struct arc_query *query)
{
    const uint32_t from = leaf * PER_ARC, n = arcs->points.n;
    for (uint32_t k = from; k < n && k < from + PER_ARC; k++)
        compare_corner(arcs, k, query);
}
//<

//> Search an arc and those below it
//> Hold an arc that waits
struct waiting_arc {
    double bound;
    uint32_t arc;
};

static inline struct waiting_arc wait_for(const struct arcs *arcs,
                                          uint32_t k,
                                          const struct arc_query *query)
{
    return (struct waiting_arc){
        arc_bound(&arcs->arc[k], query->x, query->y), k};
}

static inline bool may_be_further(const struct arcs *arcs,
                                  struct waiting_arc arc,
                                  const struct arc_query *query)
{
    return arc.bound > query->max2 ||
           (arc.bound == query->max2 &&
            arcs->arc[arc.arc].lowest < query->furthest);
}
//<

static void search_arc(const struct arcs *arcs, uint32_t k,
                       struct arc_query *query)
{
    enum { DEEPEST = 40 };
    struct waiting_arc stack[DEEPEST];
    int height = 0;
    stack[height++] = wait_for(arcs, k, query);
    while (height > 0) {
        const struct waiting_arc next = stack[--height];
        if (!may_be_further(arcs, next, query))
            continue;
        if (next.arc >= arcs->leaves - 1) {
            compare_leaf(arcs, next.arc - (arcs->leaves - 1), query);
            continue;
        }
        const struct waiting_arc a =
            wait_for(arcs, 2 * next.arc + 1, query);
        const struct waiting_arc b =
            wait_for(arcs, 2 * next.arc + 2, query);
        stack[height++] = a.bound > b.bound ? b : a;
        stack[height++] = a.bound > b.bound ? a : b;
    }
}
//<

//> Climb from arc to arc
// Each time, the other half of the arc above is searched, until all of
// the round has been looked at.
void arcs_furthest(const struct arcs *arcs, struct arc_query *query)
{
    const uint32_t leaf = query->corner / PER_ARC;
    query->max2 = -1;
    query->furthest = NO_INDEX;
    compare_leaf(arcs, leaf, query);
    for (uint32_t k = leaf + arcs->leaves - 1; k > 0; k = (k - 1) / 2)
        search_arc(arcs, k % 2 ? k + 1 : k - 1, query);
}
//<
//<

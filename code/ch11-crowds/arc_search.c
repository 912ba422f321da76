//> Search the tree of arcs
// With v = c - o and g = o - q, a corner c is at the squared distance
// |g|^2 + |v|^2 + 2 g v from the query q. The first term is known, the
// second is the same for all corners if o is the center of the arc's
// circle, and the third is at most what the arc's turned box allows.
#include "ch11-crowds/arc_search.h"
#include "common/min_max.h"

//> Bound the arcs of a node
// Each by the lesser of two bounds: that of its box, and that of its
// bend.
static inline double max_product(double factor, double low, double high)
{
    return MAX(factor * low, factor * high);
}

void arcs_bound(const struct arc_node *node, double x, double y,
                double bound[FANOUT])
{
    for (int k = 0; k < FANOUT; k++) {
        const double gx = node->ox[k] - x, gy = node->oy[k] - y;
        const double along = gx * node->tx[k] + gy * node->ty[k];
        const double beside = gy * node->tx[k] - gx * node->ty[k];
        const double bent2 =
            distance2(gx, gy) + node->max2[k] +
            2 * (max_product(along, node->along[0][k],
                             node->along[1][k]) +
                 max_product(beside, node->beside[0][k],
                             node->beside[1][k]));
        const double box2 =
            distance2(MAX(x - node->left[k], node->right[k] - x),
                      MAX(y - node->bottom[k], node->top[k] - y));
        bound[k] = MIN(bent2, box2);
    }
}
//<

//> Choose the best of some
static inline int best_arc(const double bound[FANOUT], uint32_t open)
{
    int best = __builtin_ctz(open);
    for (open &= open - 1; open; open &= open - 1) {
        const int k = __builtin_ctz(open);
        best = bound[k] > bound[best] ? k : best;
    }
    return best;
}
//<

//> Compare with the corners of an arc
// All eight, then those that are as far as the furthest of them.
static inline double max_of_eight(const double v[PER_ARC])
{
    return MAX(MAX(MAX(v[0], v[1]), MAX(v[2], v[3])),
               MAX(MAX(v[4], v[5]), MAX(v[6], v[7])));
}

void arcs_compare_leaf(const struct arcs *arcs, uint32_t leaf,
                       struct arc_query *query)
{
    const uint32_t from = leaf * PER_ARC;
    double far2[PER_ARC];
    for (int k = 0; k < PER_ARC; k++)
        far2[k] = distance2(arcs->points.x[from + k] - query->x,
                            arcs->points.y[from + k] - query->y);
    const double max2 = max_of_eight(far2);
    query->compared += MIN(PER_ARC, arcs->points.n - from);
    if (max2 < query->max2)
        return;
    for (uint32_t set = at_least(far2, max2); set; set &= set - 1) {
        const uint32_t k = from + (uint32_t)__builtin_ctz(set);
        if (max2 > query->max2 || arcs->point[k] < query->furthest) {
            query->max2 = max2;
            query->furthest = arcs->point[k];
            query->corner = MIN(k, arcs->points.n - 1);
        }
    }
}
//<

//> Search a node and those below it
// Only the arcs in this set; the best first.
void arcs_search_node(const struct arcs *arcs, int level,
                      uint32_t number, uint32_t set,
                      struct arc_query *query)
{
    const struct arc_node *node = &arcs->level[level][number];
    double bound[FANOUT];
    arcs_bound(node, query->x, query->y, bound);
    for (uint32_t open = set & at_least(bound, query->max2); open;) {
        const int k = best_arc(bound, open);
        open &= ~(1u << k);
        if (bound[k] < query->max2 ||
            (bound[k] == query->max2 &&
             node->lowest[k] >= query->furthest))
            continue;
        if (level == 0)
            arcs_compare_leaf(arcs, number * FANOUT + k, query);
        else
            arcs_search_node(arcs, level - 1, number * FANOUT + k,
                             ALL_ARCS, query);
    }
}
//<

//> Climb from arc to arc
// Each time, the other arcs of the node are searched, until all of the
// round has been looked at.
void arcs_furthest(const struct arcs *arcs, struct arc_query *query)
{
    uint32_t arc = query->corner / PER_ARC;
    query->max2 = -1;
    query->furthest = NO_INDEX;
    arcs_compare_leaf(arcs, arc, query);
    for (int level = 0; level < arcs->levels; level++) {
        arcs_search_node(arcs, level, arc / FANOUT,
                         ALL_ARCS & ~(1u << arc % FANOUT), query);
        arc /= FANOUT;
    }
}
//<
//<

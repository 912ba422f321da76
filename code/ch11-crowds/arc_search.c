//> Search the tree of arcs
// With v = c - o and g = o - q, a corner c is at the squared distance
// |g|^2 + |v|^2 + 2 g v from the query q. The first term is known, the
// second is the same for all corners if o is the center of the arc's
// circle, and the third is at most what the arc's turned box allows.
#include "ch11-crowds/arc_search.h"
#include "common/min_max.h"

//> Bound the arcs of a fan
// Each by the less of two bounds: that of its box, and that of its
// bend.
static inline double most_of(double factor, double low, double high)
{
    return MAX(factor * low, factor * high);
}

void arcs_bound(const struct fan *fan, double x, double y,
                double bound[FAN])
{
    for (int k = 0; k < FAN; k++) {
        const double gx = fan->ox[k] - x, gy = fan->oy[k] - y;
        const double along = gx * fan->tx[k] + gy * fan->ty[k];
        const double beside = gy * fan->tx[k] - gx * fan->ty[k];
        const double bent2 =
            distance2(gx, gy) + fan->max2[k] +
            2 * (most_of(along, fan->along[0][k], fan->along[1][k]) +
                 most_of(beside, fan->beside[0][k], fan->beside[1][k]));
        const double box2 =
            distance2(MAX(x - fan->left[k], fan->right[k] - x),
                      MAX(y - fan->bottom[k], fan->top[k] - y));
        bound[k] = MIN(bent2, box2);
    }
}
//<

//> Choose the best of some
static inline int best_of(const double bound[FAN], uint32_t open)
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
static inline double greatest(const double v[PER_ARC])
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
    const double max2 = greatest(far2);
    query->compared += MIN(PER_ARC, arcs->points.n - from);
    if (max2 < query->max2)
        return;
    for (uint32_t set = no_less(far2, max2); set; set &= set - 1) {
        const uint32_t k = from + (uint32_t)__builtin_ctz(set);
        if (max2 > query->max2 || arcs->point[k] < query->furthest) {
            query->max2 = max2;
            query->furthest = arcs->point[k];
            query->corner = MIN(k, arcs->points.n - 1);
        }
    }
}
//<

//> Search a fan and those below it
// Only the arcs in this set; the best first.
void arcs_search_fan(const struct arcs *arcs, int level,
                     uint32_t number, uint32_t set,
                     struct arc_query *query)
{
    const struct fan *fan = &arcs->level[level][number];
    double bound[FAN];
    arcs_bound(fan, query->x, query->y, bound);
    for (uint32_t open = set & no_less(bound, query->max2); open;) {
        const int k = best_of(bound, open);
        open &= ~(1u << k);
        if (bound[k] < query->max2 ||
            (bound[k] == query->max2 &&
             fan->lowest[k] >= query->furthest))
            continue;
        if (level == 0)
            arcs_compare_leaf(arcs, number * FAN + k, query);
        else
            arcs_search_fan(arcs, level - 1, number * FAN + k, ALL_ARCS,
                            query);
    }
}
//<

//> Climb from arc to arc
// Each time, the other arcs of the fan are searched, until all of the
// round has been looked at.
void arcs_furthest(const struct arcs *arcs, struct arc_query *query)
{
    uint32_t arc = query->corner / PER_ARC;
    query->max2 = -1;
    query->furthest = NO_INDEX;
    arcs_compare_leaf(arcs, arc, query);
    for (int level = 0; level < arcs->levels; level++) {
        arcs_search_fan(arcs, level, arc / FAN,
                        ALL_ARCS & ~(1u << arc % FAN), query);
        arc /= FAN;
    }
}
//<
//<

//> Make a shortlist of arcs
// Down from the whole round into those arcs that can have the furthest
// corner of something in the box; if few, down to single corners.
#include "ch11-crowds/arc_search.h"
#include "common/min_max.h"
#include <math.h>

//> List the arcs for a box
// Let c be the middle of the box, r as far as it reaches from there, b
// the furthest corner of c, and a corner a in some arc. For a query q
// in the box,
//     |q - a|^2 - |q - b|^2
//         = |c - a|^2 - |c - b|^2 + 2 (q - c)(b - a)
// is at most |c - a|^2 - |c - b|^2 + 2 r |b - a|. If that is negative
// for the bound of the arc, and by more than rounding can do, b is
// further than all of the arc, from everywhere in the box. Rounding: of
// four squared distances 4 u each, of the product and two sums 4 more,
// together 20 u diameter^2, where u is 2^-53; 2^-44 is 512 u.
struct listing {
    const struct arcs *arcs;
    struct arc_query *middle; // c, and its furthest
    double x, y, twice_r;     // b, and 2 r
    struct shortlist *list;
};

//> Raise the bounds for all of a box
static double slack(const struct listing *listing, double apart2)
{
    const double diameter = listing->arcs->diameter;
    return listing->twice_r * sqrt(apart2) +
           0x1p-44 * diameter * diameter;
}

static void add_slack(const struct listing *listing,
                      const struct arc_node *node, double bound[FANOUT])
{
    const double x = listing->x, y = listing->y;
    for (int k = 0; k < FANOUT; k++)
        bound[k] += slack(
            listing,
            distance2(MAX(x - node->left[k], node->right[k] - x),
                      MAX(y - node->bottom[k], node->top[k] - y)));
}
//<

//> List the arcs of a node
static void list_node(const struct listing *listing, int level,
                      uint32_t number)
{
    const struct arc_node *node = &listing->arcs->level[level][number];
    struct shortlist *list = listing->list;
    double bound[FANOUT];
    arcs_bound(node, listing->middle->x, listing->middle->y, bound);
    add_slack(listing, node, bound);
    uint32_t open = at_least(bound, listing->middle->max2);
    if (open == 0 || !list->complete)
        return;
    if (level > 0) {
        for (; open; open &= open - 1)
            list_node(listing, level - 1,
                      number * FANOUT + (uint32_t)__builtin_ctz(open));
    } else if (list->nodes == MAX_LISTED) {
        list->complete = false;
    } else {
        list->node[list->nodes] = number;
        list->set[list->nodes++] = open;
    }
}
//<
//<

//> List corners
// Each as if it were an arc of its own.
static void list_corner(const struct listing *listing, uint32_t k)
{
    const struct arc_query *c = listing->middle;
    const struct arcs *arcs = listing->arcs;
    const double x = arcs->points.x[k], y = arcs->points.y[k];
    struct shortlist *list = listing->list;
    const double apart2 = distance2(x - listing->x, y - listing->y);
    if (distance2(x - c->x, y - c->y) + slack(listing, apart2) <
        c->max2)
        return;
    list->is_short &= list->corners < MAX_CORNERS;
    if (list->is_short)
        list->corner[list->corners++] = k;
}

static void list_corners(const struct listing *listing)
{
    struct shortlist *list = listing->list;
    const uint32_t n = listing->arcs->points.n;
    list->is_short = list->complete;
    list->corners = 0;
    for (int f = 0; f < list->nodes; f++)
        for (uint32_t set = list->set[f]; set && list->is_short;
             set &= set - 1) {
            const uint32_t arc =
                list->node[f] * FANOUT + (uint32_t)__builtin_ctz(set);
            const uint32_t from = arc * PER_ARC;
            const uint32_t end = from + MIN(PER_ARC, n - from);
            for (uint32_t k = from; k < end; k++)
                list_corner(listing, k);
            listing->middle->compared += end - from;
        }
}
//<

//> List what a box needs
void arcs_list(const struct arcs *arcs, const struct box *box,
               struct arc_query *query, struct shortlist *list)
{
    query->x = box->left + (box->right - box->left) / 2;
    query->y = box->bottom + (box->top - box->bottom) / 2;
    arcs_furthest(arcs, query);
    const double r = sqrt(
        distance2(MAX(query->x - box->left, box->right - query->x),
                  MAX(query->y - box->bottom, box->top - query->y)));
    const struct listing listing = {arcs,
                                    query,
                                    arcs->points.x[query->corner],
                                    arcs->points.y[query->corner],
                                    2 * r * (1 + 0x1p-40),
                                    list};
    list->complete = true;
    list->nodes = 0;
    list_node(&listing, arcs->levels - 1, 0);
    list_corners(&listing);
}
//<

//> Search a shortlist
static void compare_listed(const struct arcs *arcs,
                           const struct shortlist *list,
                           struct arc_query *query)
{
    for (int c = 0; c < list->corners; c++) {
        const uint32_t k = list->corner[c];
        const double far2 = distance2(arcs->points.x[k] - query->x,
                                      arcs->points.y[k] - query->y);
        if (far2 > query->max2 ||
            (far2 == query->max2 && arcs->point[k] < query->furthest)) {
            query->max2 = far2;
            query->furthest = arcs->point[k];
            query->corner = k;
        }
    }
    query->compared += (uint64_t)list->corners;
}

static void search_listed(const struct arcs *arcs,
                          const struct shortlist *list,
                          struct arc_query *query)
{
    const uint32_t leaf = query->corner / PER_ARC;
    arcs_compare_leaf(arcs, leaf, query);
    for (int k = 0; k < list->nodes; k++) {
        const bool again = list->node[k] == leaf / FANOUT;
        arcs_search_node(
            arcs, 0, list->node[k],
            list->set[k] & ~((uint32_t)again << leaf % FANOUT), query);
    }
}

void arcs_furthest_listed(const struct arcs *arcs,
                          const struct shortlist *list,
                          struct arc_query *query)
{
    query->max2 = -1;
    query->furthest = NO_INDEX;
    if (list->is_short)
        compare_listed(arcs, list, query);
    else
        search_listed(arcs, list, query);
}
//<
//<

//> Query all pieces
// A stack of boxes that may hold something better. In a piece, the rows
// of its grid that can, and of each row a span. Few boxes are entered
// in practice; no bound is proved, so the steps are counted.
#include "ch11-crowds/tree_query.h"
#include "ch09-row-spans/span_kernels.h"
#include "ch11-crowds/node_stack.h"
#include "ch11-crowds/piece_rows.h"

//> Compare with a stretch of points
// Not with one that is longer than the steps that are left: with it the
// query gives up.
static bool can_afford(struct tree_query *query, uint32_t points)
{
    query->steps += points;
    return query->steps <= query->max_steps;
}

void compare_nearest(struct tree_query *query, uint32_t begin,
                     uint32_t end)
{
    if (!can_afford(query, end - begin))
        return;
    query->all->kernels->compare(query->all, begin, end, &query->query);
    query->query.compared += end - begin;
}

void compare_furthest(struct tree_query *query, uint32_t begin,
                      uint32_t end)
{
    const struct points p = query->pieces->sorted.points;
    const uint32_t *point = query->pieces->sorted.cells.point;
    struct query *q = &query->query;
    if (!can_afford(query, end - begin))
        return;
    for (uint32_t s = begin; s < end; s++) {
        const double far2 =
            furthest2(query->all->space, p.x[s] - q->x, p.y[s] - q->y);
        if (point[s] != q->self)
            query_keep(q, point[s], -far2);
    }
    q->compared += end - begin;
}
//<

//> Search what is in one place
// All at one distance: the lowest index will do. But if they are only
// nearly in one place, and far away, they are compared.
INLINED void search_place(const enum geometry geometry,
                          const bool furthest,
                          const struct piece *piece,
                          const struct node *node,
                          struct tree_query *query)
{
    struct query *q = &query->query;
    const uint32_t n = piece->sorted.points.n;
    const uint32_t index =
        piece->lowest != q->self ? piece->lowest : piece->second;
    if (index == NO_INDEX)
        return;
    if (!box_is_place(&node->box)) {
        compare_points(furthest, query, piece->begin, piece->begin + n);
        return;
    }
    query_keep(q, index,
               box_bound(geometry, furthest, query->all->space,
                         &node->box, q->x, q->y));
    q->compared++;
    query->steps++;
}
//<

//> Take a box where all distances vanish
// Its squares vanish: then the lowest index will do.
static bool take_vanishing(const struct node *node, struct query *query)
{
    if (query->best2 > 0 || node->lowest == query->self ||
        box_far2(&node->box, query->x, query->y) > 0)
        return false;
    query_keep(query, node->lowest, 0);
    return true;
}
//<

//> Search down the tree of boxes
INLINED bool query_tree(const enum geometry geometry,
                        const bool furthest, struct tree_query *query)
{
    const struct pieces *pieces = query->pieces;
    struct query *q = &query->query;
    struct node_stack stack;
    stack.height = 1;
    stack.waiting[0] = (struct waiting){-INFINITY, 0};
    while (stack.height > 0 && query->steps <= query->max_steps) {
        const struct waiting next = stack.waiting[--stack.height];
        const struct node *node = &pieces->node[next.node];
        if (!can_be_better(q, next.bound, node->lowest))
            continue;
        query->steps++;
        if (!furthest && take_vanishing(node, q))
            continue;
        if (node->first_child == 0) {
            const struct piece *piece = &pieces->piece[node->piece];
            if (piece->is_place)
                search_place(geometry, furthest, piece, node, query);
            else
                search_rows(geometry, furthest, piece, node->box,
                            query);
            continue;
        }
        struct waiting a = {0, node->first_child};
        struct waiting b = {0, node->second_child};
        a.bound = box_bound(geometry, furthest, query->all->space,
                            &pieces->node[a.node].box, q->x, q->y);
        b.bound = box_bound(geometry, furthest, query->all->space,
                            &pieces->node[b.node].box, q->x, q->y);
        push_children(&stack, a, b);
    }
    return query->steps <= query->max_steps;
}

//> Search near or far, with a copy for each geometry
bool query_nearest(struct tree_query *query)
{
    return query->all->space.geometry == STANDARD
               ? query_tree(STANDARD, false, query)
               : query_tree(WRAPAROUND, false, query);
}

bool query_furthest(struct tree_query *query)
{
    return query->all->space.geometry == STANDARD
               ? query_tree(STANDARD, true, query)
               : query_tree(WRAPAROUND, true, query);
}
//<
//<
//<

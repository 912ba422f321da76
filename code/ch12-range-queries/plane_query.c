//> Query the plane
// First a block, then down the tree of boxes, as chapter 11 does. What
// is as far as the last is looked at, since its index may be lower.
// Even points take a few k distances; for crowds no bound is proved.
#include "ch12-range-queries/plane_query.h"
#include "ch11-crowds/node_stack.h"
#include "ch12-range-queries/plane_rows.h"

//> Take what is in one place
// Where all are equally far, and only the k nearest are wanted, those
// with the lowest indices will do: they come first. One more, since one
// may be the query.
INLINED void take_place(const enum geometry geometry,
                        const struct piece *piece,
                        const struct node *node,
                        struct plane_query *query)
{
    const double far2 = box_far2(&node->box, query->x, query->y);
    const bool alike = box_is_place(&node->box) || far2 == 0;
    uint32_t n = piece->sorted.points.n;
    if (alike && query->list->found)
        n = MIN(n - 1, query->list->k) + 1;
    take_span(geometry, query, piece->begin, piece->begin + n);
}
//<

//> Count a piece that is within reach as a whole
// Returns false if it is not.
static bool count_whole(const struct piece *piece,
                        const struct node *node,
                        struct plane_query *query)
{
    if (query->list->found ||
        box_far2(&node->box, query->x, query->y) > query->list->reach2)
        return false;
    query->list->count +=
        piece->sorted.points.n - (piece == query->piece);
    return true;
}
//<

//> Take a piece
INLINED void take_piece(const enum geometry geometry,
                        const struct node *node,
                        struct plane_query *query)
{
    const struct piece *piece =
        &query->index->pieces.piece[node->piece];
    if (count_whole(piece, node, query))
        return;
    if (piece->is_place)
        take_place(geometry, piece, node, query);
    else
        take_rows(geometry, piece, node->box, query);
    if (query->list->found && query->list->count > query->list->k)
        keep_k_nearest(query->list);
}
//<

//> Decide whether a box can have a neighbor
// At the reach itself only if its lowest index is below that of the
// k-th: so many places that are equally far are not all looked at.
static bool can_have(const struct k_nearest_list *list, double bound,
                     uint32_t lowest)
{
    if (bound != list->reach2 || !list->found)
        return bound <= list->reach2;
    return list->ordered < list->k ||
           lowest < list->found[list->k - 1].index;
}
//<

//> Search the boxes within reach
// The nearer one first. A stack as in chapter 11.
INLINED void search_boxes(const enum geometry geometry,
                          struct plane_query *query)
{
    const struct node *nodes = query->index->pieces.node;
    struct node_stack stack;
    stack.height = 1;
    stack.waiting[0] = (struct waiting){0, 0};
    while (stack.height > 0) {
        const struct waiting next = stack.waiting[--stack.height];
        const struct node *node = &nodes[next.node];
        if (!can_have(query->list, next.bound, node->lowest))
            continue;
        query->steps++;
        if (node->first_child == 0) {
            take_piece(geometry, node, query);
            continue;
        }
        struct waiting a = {0, node->first_child};
        struct waiting b = {0, node->second_child};
        a.bound = box_bound(geometry, false, query->index->space,
                            &nodes[a.node].box, query->x, query->y);
        b.bound = box_bound(geometry, false, query->index->space,
                            &nodes[b.node].box, query->x, query->y);
        push_children(&stack, a, b);
    }
}
//<

//> Count the points of a block
static uint32_t points_of_block(const struct piece *piece,
                                const struct cell_block *block)
{
    const uint32_t columns = piece->sorted.grid.x.count;
    uint32_t count = 0;
    for (uint32_t row = block->bottom; row <= block->top; row++) {
        const uint32_t *start =
            piece->sorted.cells.start + (size_t)row * columns;
        count += start[block->right + 1] - start[block->left];
    }
    return count;
}
//<

//> Choose the first block of a query
// Of cells, around that of the query: as large as it must be for k
// points and the query if these are even; and larger, if it has fewer.
static void choose_block(struct plane_query *query)
{
    const struct grid *grid = &query->piece->sorted.grid;
    const uint32_t columns = grid->x.count, rows = grid->y.count;
    const uint32_t column = axis_cell(&grid->x, query->x);
    const uint32_t row = axis_cell(&grid->y, query->y);
    const uint32_t wanted =
        MIN(query->list->k, query->piece->sorted.points.n - 1);
    const double cells = wanted / (double)POINTS_PER_PLANE_CELL;
    uint32_t radius = 1;
    if (cells > 9)
        radius = (uint32_t)(sqrt(cells) / 2);
    struct cell_block *block = &query->block;
    do {
        block->left = column - MIN(column, radius);
        block->right = MIN(columns - 1 - column, radius) + column;
        block->bottom = row - MIN(row, radius);
        block->top = MIN(rows - 1 - row, radius) + row;
        radius += 1 + radius / 4;
    } while (points_of_block(query->piece, block) <= wanted);
    query->has_block = true;
}
//<

//> Look whether the block is enough
// It is if nothing outside is within reach. Where it ends with its
// piece, what is outside begins where the piece's region ends; with
// wraparound images begin where all points end.
INLINED double way_out(const struct axis *axis, uint32_t first,
                       uint32_t last, struct extent region, double x)
{
    const double low = first > 0 ? axis->border[first] : region.low;
    const double high =
        last + 1 < axis->count ? axis->border[last + 1] : region.high;
    return MIN(x - low, high - x);
}

INLINED bool is_enough(const enum geometry geometry,
                       const struct plane_query *query)
{
    const struct grid *grid = &query->piece->sorted.grid;
    //> Take the region, with wraparound within the box of all
    const struct box *all = &query->index->pieces.node[0].box;
    struct box r = query->piece->region;
    if (geometry == WRAPAROUND)
        r = (struct box){
            MAX(r.left, all->left), MIN(r.right, all->right),
            MAX(r.bottom, all->bottom), MIN(r.top, all->top)};
    //<
    const struct cell_block *block = &query->block;
    const struct space space = query->index->space;
    const double across =
        way_out(&grid->x, block->left, block->right,
                (struct extent){r.left, r.right}, query->x) -
        slack(geometry, query->x, space.width);
    const double up =
        way_out(&grid->y, block->bottom, block->top,
                (struct extent){r.bottom, r.top}, query->y) -
        slack(geometry, query->y, space.height);
    const double margin = MIN(across, up);
    return margin > 0 && query->list->reach2 < margin * margin;
}
//<

//> Take the first block
INLINED void take_block(const enum geometry geometry,
                        struct plane_query *query)
{
    const struct piece *piece = query->piece;
    choose_block(query);
    const struct cell_block *block = &query->block;
    for (uint32_t row = block->bottom; row <= block->top; row++) {
        const uint32_t *start =
            piece->sorted.cells.start +
            (size_t)row * piece->sorted.grid.x.count;
        take_span(geometry, query, piece->begin + start[block->left],
                  piece->begin + start[block->right + 1]);
    }
    keep_k_nearest(query->list);
}
//<

//> Run a query
INLINED void run_query(const enum geometry geometry,
                       struct plane_query *query)
{
    const bool nearest = query->list->reach2 == INFINITY;
    if (nearest && query->list->found && !query->piece->is_place) {
        take_block(geometry, query);
        if (is_enough(geometry, query))
            return;
    }
    search_boxes(geometry, query);
}

void plane_query_run(struct plane_query *query)
{
    if (query->index->space.geometry == STANDARD)
        run_query(STANDARD, query);
    else
        run_query(WRAPAROUND, query);
}
//<
//<

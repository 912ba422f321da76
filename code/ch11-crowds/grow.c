//> Grow the pieces of a leaf
// Look at the box, fit a grid, count the points of its cells; cut and
// begin again if they crowd, sort them if not. Nothing is moved until
// then but the numbers of the records.
#include "ch11-crowds/grow.h"
#include "ch09-row-spans/row_spans.h"
#include "common/min_max.h"
#include <math.h>
#include <string.h>

//> Hold a leaf that grows
struct leaf_state {
    const struct leaf_context *context;
    uint32_t first_piece, pieces; // of the leaf; how many so far
    uint32_t slots;               // how many more cuts it may make
    uint32_t next_node;           // that it may use
};

struct part {
    uint32_t begin, end;
    struct box region;
    uint32_t cuts; // to be made before its points are counted
};
//<

//> Fit a grid to a box
// As chapter 4 does it, to two corners in place of n points, with
// borders in the room that belongs to these points.
static struct grid fit_grid(const struct leaf_state *state,
                            const struct part *part,
                            const struct box *box)
{
    const uint32_t n = part->end - part->begin;
    const size_t number = state->first_piece + state->pieces;
    const size_t begin = border_begin(part->begin, number);
    const size_t end = border_begin(part->end, number + 1);
    struct workspace room = {
        .block[0] = {(char *)(state->context->border + begin),
                     (end - begin) * sizeof(double), 0}};
    double x[2] = {box->left, box->right};
    double y[2] = {box->bottom, box->top};
    const struct question corners = {
        .points = {2, x, y}, .space.geometry = STANDARD, .threads = 1};
    return grid_fit_in(&room, &corners, 2 * POINTS_PER_SPAN_CELL / n);
}
//<

//> Count the points of the cells
// And say how many there are, on average, in the cell of a point.
static double count_cells(const struct leaf_state *state,
                          const struct part *part, struct piece *piece)
{
    struct point_record *record = state->context->record;
    const uint32_t *list = state->context->pieces->sorted.cells.point;
    const struct grid *grid = &piece->sorted.grid;
    uint32_t *next = piece->sorted.cells.start + 1;
    const uint32_t m = grid_cells(grid);
    memset(next, 0, m * sizeof *next);
    for (uint32_t k = part->begin; k < part->end; k++) {
        struct point_record *r = &record[list[k]];
        r->cell = grid_cell(grid, r->x, r->y);
        next[r->cell]++;
    }
    double together = 0;
    for (uint32_t cell = 0; cell < m; cell++)
        together += (double)next[cell] * next[cell];
    return together / (part->end - part->begin);
}
//<

//> Sort a piece
// Scan and place, as in chapter 5.
static void unpack(const struct leaf_state *state,
                   const struct part *part)
{
    const struct pieces *pieces = state->context->pieces;
    const struct point_record *record = state->context->record;
    for (uint32_t s = part->begin; s < part->end; s++) {
        const struct point_record *r = &record[pieces->inverse[s]];
        pieces->sorted.points.x[s] = r->x;
        pieces->sorted.points.y[s] = r->y;
        pieces->sorted.cells.point[s] = r->point;
    }
}

static void sort_piece(const struct leaf_state *state,
                       const struct part *part, struct piece *piece)
{
    const struct pieces *pieces = state->context->pieces;
    const struct point_record *record = state->context->record;
    uint32_t *start = piece->sorted.cells.start;
    uint32_t *to = pieces->inverse + part->begin;
    start[0] = 0;
    cells_scan(start + 1, grid_cells(&piece->sorted.grid), 0);
    for (uint32_t k = part->begin; k < part->end; k++) {
        const uint32_t number = pieces->sorted.cells.point[k];
        to[start[record[number].cell + 1]++] = number;
    }
    unpack(state, part);
}
//<

//> Begin a piece
static struct piece *begin_piece(const struct leaf_state *state,
                                 const struct part *part)
{
    const struct pieces *pieces = state->context->pieces;
    const uint32_t number = state->first_piece + state->pieces;
    struct piece *piece = &pieces->piece[number];
    const uint32_t begin = part->begin;
    *piece = (struct piece){
        .sorted = {.points = {part->end - begin,
                              pieces->sorted.points.x + begin,
                              pieces->sorted.points.y + begin},
                   .cells = {state->context->start +
                                 start_begin(begin, number),
                             pieces->sorted.cells.point + begin}},
        .region = part->region,
        .begin = begin};
    return piece;
}
//<

//> End a piece in one place
static void end_place(const struct leaf_state *state,
                      const struct part *part, struct piece *piece)
{
    const struct pieces *pieces = state->context->pieces;
    piece->is_place = true;
    memcpy(pieces->inverse + part->begin,
           pieces->sorted.cells.point + part->begin,
           (part->end - part->begin) * sizeof(uint32_t));
    unpack(state, part);
    piece->lowest = piece->second = NO_INDEX;
    for (uint32_t s = part->begin; s < part->end; s++) {
        const uint32_t i = pieces->sorted.cells.point[s];
        piece->second = MAX(MIN(i, piece->second), piece->lowest);
        piece->lowest = MIN(i, piece->lowest);
    }
}
//<

static void grow(struct leaf_state *state, const struct part *part,
                 struct node *node);

//> Cut a part
static void grow_two(struct leaf_state *state, const struct part *part,
                     struct node *node)
{
    const struct leaf_context *context = state->context;
    struct part sides[2] = {*part, *part};
    struct cut cut;
    const uint32_t middle =
        part->begin +
        cut_list(context->record,
                 context->pieces->sorted.cells.point + part->begin,
                 part->end - part->begin, &node->box,
                 (struct cut_room){
                     context->pieces->sorted.points.x + part->begin,
                     context->pieces->inverse + part->begin},
                 &cut);
    sides[0].end = sides[1].begin = middle;
    *(cut.by_y ? &sides[0].region.top : &sides[0].region.right) =
        cut.at;
    *(cut.by_y ? &sides[1].region.bottom : &sides[1].region.left) =
        cut.at;
    node->first_child = state->next_node++;
    node->second_child = state->next_node++;
    state->slots--;
    grow(state, &sides[0], &context->pieces->node[node->first_child]);
    grow(state, &sides[1], &context->pieces->node[node->second_child]);
}
//<

//> Survey a part
// Its box, and the lowest index.
static void survey(const struct leaf_context *context,
                   const struct part *part, struct node *node)
{
    const uint32_t *list =
        context->pieces->sorted.cells.point + part->begin;
    const uint32_t n = part->end - part->begin;
    *node = (struct node){box_of(context->record, list, n), NO_INDEX};
    for (uint32_t k = 0; k < n; k++)
        node->lowest =
            MIN(context->record[list[k]].point, node->lowest);
}
//<

//> Decide whether to cut
// A cut costs less than a count of cells. So where the crowding is
// many times too large, several cuts are made before the next count.
static uint32_t cuts_wanted(const struct leaf_state *state,
                            const struct part *part,
                            struct piece *piece, const struct box *box)
{
    const bool may =
        part->end - part->begin >= FEWEST_TO_CUT && state->slots > 0;
    if (may && part->cuts > 0)
        return part->cuts;
    piece->sorted.grid = fit_grid(state, part, box);
    const double together = count_cells(state, part, piece);
    if (!may || together <= CROWDED)
        return 0;
    return 1 + (uint32_t)log2(together / CROWDED);
}
//<

//> Grow a part
// No more pieces than there is room for: each part that waits to be
// grown has a slot.
static void grow(struct leaf_state *state, const struct part *part,
                 struct node *node)
{
    const uint32_t n = part->end - part->begin;
    survey(state->context, part, node);
    const struct box *box = &node->box;
    struct piece *piece = begin_piece(state, part);
    if (n == 0 || distance2(box->right - box->left,
                            box->top - box->bottom) == 0) {
        end_place(state, part, piece);
    } else {
        const uint32_t cuts = cuts_wanted(state, part, piece, box);
        if (cuts > 0) {
            struct part again = *part;
            again.cuts = cuts - 1;
            grow_two(state, &again, node);
            return;
        }
        sort_piece(state, part, piece);
    }
    node->piece = state->first_piece + state->pieces++;
}
//<

uint32_t grow_leaf(const struct leaf_context *context,
                   const struct leaf *leaf)
{
    struct leaf_state state = {
        .context = context,
        .first_piece = leaf->piece,
        .slots = piece_slots(leaf->end - leaf->begin) - 1,
        .next_node = leaf->node + 1};
    const struct part all = {leaf->begin, leaf->end, leaf->region, 0};
    for (uint32_t k = leaf->begin; k < leaf->end; k++)
        context->pieces->sorted.cells.point[k] = k;
    grow(&state, &all, &context->pieces->node[leaf->node]);
    return state.pieces;
}
//<

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
struct growing {
    const struct growth *growth;
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
static struct grid fit_grid(const struct growing *growing,
                            const struct part *part,
                            const struct box *box)
{
    const uint32_t n = part->end - part->begin;
    const size_t number = growing->first_piece + growing->pieces;
    const size_t begin = border_begin(part->begin, number);
    const size_t end = border_begin(part->end, number + 1);
    struct workspace room = {
        .block[0] = {(char *)(growing->growth->border + begin),
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
static double count_cells(const struct growing *growing,
                          const struct part *part, struct piece *piece)
{
    struct point_record *record = growing->growth->record;
    const uint32_t *list = growing->growth->pieces->sorted.cells.point;
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
static void unpack(const struct growing *growing,
                   const struct part *part)
{
    const struct pieces *pieces = growing->growth->pieces;
    const struct point_record *record = growing->growth->record;
    for (uint32_t s = part->begin; s < part->end; s++) {
        const struct point_record *r = &record[pieces->inverse[s]];
        pieces->sorted.points.x[s] = r->x;
        pieces->sorted.points.y[s] = r->y;
        pieces->sorted.cells.point[s] = r->point;
    }
}

static void sort_piece(const struct growing *growing,
                       const struct part *part, struct piece *piece)
{
    const struct pieces *pieces = growing->growth->pieces;
    const struct point_record *record = growing->growth->record;
    uint32_t *start = piece->sorted.cells.start;
    start[0] = 0;
    cells_scan(start + 1, grid_cells(&piece->sorted.grid), 0);
    for (uint32_t k = part->begin; k < part->end; k++) {
        const uint32_t number = pieces->sorted.cells.point[k];
        pieces
            ->inverse[part->begin + start[record[number].cell + 1]++] =
            number;
    }
    unpack(growing, part);
}
//<

//> Begin a piece
static struct piece *begin_piece(const struct growing *growing,
                                 const struct part *part)
{
    const struct pieces *pieces = growing->growth->pieces;
    const uint32_t number = growing->first_piece + growing->pieces;
    struct piece *piece = &pieces->piece[number];
    const uint32_t begin = part->begin;
    *piece = (struct piece){
        .sorted = {.points = {part->end - begin,
                              pieces->sorted.points.x + begin,
                              pieces->sorted.points.y + begin},
                   .cells = {growing->growth->start +
                                 start_begin(begin, number),
                             pieces->sorted.cells.point + begin}},
        .region = part->region,
        .begin = begin};
    return piece;
}
//<

//> End a piece in one place
static void end_place(const struct growing *growing,
                      const struct part *part, struct piece *piece)
{
    const struct pieces *pieces = growing->growth->pieces;
    piece->is_place = true;
    memcpy(pieces->inverse + part->begin,
           pieces->sorted.cells.point + part->begin,
           (part->end - part->begin) * sizeof(uint32_t));
    unpack(growing, part);
    piece->lowest = piece->second = NO_INDEX;
    for (uint32_t s = part->begin; s < part->end; s++) {
        const uint32_t i = pieces->sorted.cells.point[s];
        piece->second = MAX(MIN(i, piece->second), piece->lowest);
        piece->lowest = MIN(i, piece->lowest);
    }
}
//<

static void grow(struct growing *growing, const struct part *part,
                 struct node *node);

//> Cut a part
static void grow_two(struct growing *growing, const struct part *part,
                     struct node *node)
{
    const struct growth *growth = growing->growth;
    struct part sides[2] = {*part, *part};
    struct cut cut;
    const uint32_t middle =
        part->begin +
        cut_list(growth->record,
                 growth->pieces->sorted.cells.point + part->begin,
                 part->end - part->begin, &node->box,
                 (struct cut_room){
                     growth->pieces->sorted.points.x + part->begin,
                     growth->pieces->inverse + part->begin},
                 &cut);
    sides[0].end = sides[1].begin = middle;
    *(cut.by_y ? &sides[0].region.top : &sides[0].region.right) =
        cut.at;
    *(cut.by_y ? &sides[1].region.bottom : &sides[1].region.left) =
        cut.at;
    node->first_child = growing->next_node++;
    node->second_child = growing->next_node++;
    growing->slots--;
    grow(growing, &sides[0], &growth->pieces->node[node->first_child]);
    grow(growing, &sides[1], &growth->pieces->node[node->second_child]);
}
//<

//> Survey a part
// Its box, and the lowest index.
static void survey(const struct growth *growth, const struct part *part,
                   struct node *node)
{
    const uint32_t *list =
        growth->pieces->sorted.cells.point + part->begin;
    const uint32_t n = part->end - part->begin;
    *node = (struct node){box_of(growth->record, list, n), NO_INDEX};
    for (uint32_t k = 0; k < n; k++)
        node->lowest = MIN(growth->record[list[k]].point, node->lowest);
}
//<

//> Decide whether to cut
// A cut costs less than a count of cells. So where the crowding is
// many times too large, several cuts are made before the next count.
static uint32_t cuts_wanted(const struct growing *growing,
                            const struct part *part,
                            struct piece *piece, const struct box *box)
{
    const bool may =
        part->end - part->begin >= FEWEST_TO_CUT && growing->slots > 0;
    if (may && part->cuts > 0)
        return part->cuts;
    piece->sorted.grid = fit_grid(growing, part, box);
    const double together = count_cells(growing, part, piece);
    if (!may || together <= CROWDED)
        return 0;
    return 1 + (uint32_t)log2(together / CROWDED);
}
//<

//> Grow a part
// No more pieces than there is room for: each part that waits to be
// grown has a slot.
static void grow(struct growing *growing, const struct part *part,
                 struct node *node)
{
    const uint32_t n = part->end - part->begin;
    survey(growing->growth, part, node);
    const struct box *box = &node->box;
    struct piece *piece = begin_piece(growing, part);
    if (n == 0 || distance2(box->right - box->left,
                            box->top - box->bottom) == 0) {
        end_place(growing, part, piece);
    } else {
        const uint32_t cuts = cuts_wanted(growing, part, piece, box);
        if (cuts > 0) {
            struct part again = *part;
            again.cuts = cuts - 1;
            grow_two(growing, &again, node);
            return;
        }
        sort_piece(growing, part, piece);
    }
    node->piece = growing->first_piece + growing->pieces++;
}
//<

uint32_t grow_leaf(const struct growth *growth, const struct leaf *leaf)
{
    struct growing growing = {
        .growth = growth,
        .first_piece = leaf->piece,
        .slots = piece_slots(leaf->end - leaf->begin) - 1,
        .next_node = leaf->node + 1};
    const struct part all = {leaf->begin, leaf->end, leaf->region, 0};
    for (uint32_t k = leaf->begin; k < leaf->end; k++)
        growth->pieces->sorted.cells.point[k] = k;
    grow(&growing, &all, &growth->pieces->node[leaf->node]);
    return growing.pieces;
}
//<

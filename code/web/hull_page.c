// The octagon and the hull of chapter 10, and the pieces of chapter 11,
// for a page to draw: a call makes them, the others say where they are.
#include "ch10-furthest/hull.h"
#include "ch10-furthest/octagon.h"
#include "ch11-crowds/pieces.h"
#include "web/page.h"

static struct workspace workspace;
static struct sides sides;
static uint32_t *kept;
static struct corners corners;
static struct pieces pieces;
static struct mark empty;

static void forget(void)
{
    workspace_release(&workspace, empty);
}

// Throws away what the octagon encloses; returns how many points are
// left.
uint32_t EXPORT(octagon)(void)
{
    const struct points p = page_question.points;
    forget();
    kept = workspace_take(&workspace, p.n, sizeof *kept);
    sides = octagon_sides(p, 1);
    return octagon_outside(p, &sides, 1, &workspace, kept);
}

uint32_t *EXPORT(outside_octagon)(void)
{
    return kept;
}

// a x + b y = c, from the low corner of the box on, for eight sides.
double *EXPORT(side_a)(void)
{
    return sides.a;
}
double *EXPORT(side_b)(void)
{
    return sides.b;
}
double *EXPORT(side_c)(void)
{
    return sides.c;
}
double EXPORT(side_left)(void)
{
    return sides.left;
}
double EXPORT(side_bottom)(void)
{
    return sides.bottom;
}

// Finds the corners of the hull; returns how many there are.
uint32_t EXPORT(hull)(void)
{
    forget();
    corners = corners_find(&page_question, &workspace);
    return corners.points.n;
}

uint32_t *EXPORT(hull_corner)(void)
{
    return corners.point;
}

// Cuts the points into pieces; returns how many nodes the tree of their
// boxes has.
static uint32_t nodes_below(uint32_t k)
{
    const struct node *node = &pieces.node[k];
    return node->first_child == 0 ? 1
                                  : 1 + nodes_below(node->first_child) +
                                        nodes_below(node->second_child);
}

uint32_t EXPORT(cut_pieces)(void)
{
    forget();
    pieces = pieces_make(&page_question, &workspace);
    return nodes_below(0);
}

uint32_t EXPORT(leaves)(void)
{
    return pieces.leaves;
}
uint32_t EXPORT(first_piece)(uint32_t leaf)
{
    return pieces.first[leaf];
}
uint32_t EXPORT(piece_count)(uint32_t leaf)
{
    return pieces.count[leaf];
}

// left, right, bottom, top of a piece's region.
const double *EXPORT(piece_region)(uint32_t k)
{
    return &pieces.piece[k].region.left;
}

uint32_t EXPORT(piece_points)(uint32_t k)
{
    return pieces.piece[k].sorted.points.n;
}

uint32_t EXPORT(piece_columns)(uint32_t k)
{
    return pieces.piece[k].is_place
               ? 0
               : pieces.piece[k].sorted.grid.x.count;
}

uint32_t EXPORT(piece_rows)(uint32_t k)
{
    return pieces.piece[k].is_place
               ? 0
               : pieces.piece[k].sorted.grid.y.count;
}

const double *EXPORT(piece_column_border)(uint32_t k)
{
    return pieces.piece[k].sorted.grid.x.border;
}

const double *EXPORT(piece_row_border)(uint32_t k)
{
    return pieces.piece[k].sorted.grid.y.border;
}

// Where the points of each cell of a piece begin.
const uint32_t *EXPORT(piece_start)(uint32_t k)
{
    return pieces.piece[k].sorted.cells.start;
}

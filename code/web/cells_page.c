// The cells of the page's points, as chapters 4, 7, 9 and 10 search
// them, and what a query meets there.
#include "ch04-cell-sort/sorted.h"
#include "ch04-cell-sort/visit.h"
#include "ch06-pack-scan/primitives.h"
#include "ch07-spiral/spiral_search.h"
#include "ch10-furthest/coursework_furthest.h"
#include "web/page.h"
#include <stddef.h>

static struct sorted sorted;
static bool there;

void page_forget_cells(void)
{
    if (there)
        sorted_free(&sorted);
    there = false;
}

// Sorts the points into cells of so many on average; returns how many
// cells there are.
uint32_t EXPORT(sort_cells)(double per_cell)
{
    page_forget_cells();
    sorted = sorted_make(&page_question, per_cell);
    there = true;
    return grid_cells(&sorted.grid);
}

// Sorts the points, all in the unit square, into so many columns and
// rows of it, however many points there are and wherever they lie.
void EXPORT(sort_in_square)(uint32_t columns, uint32_t rows)
{
    const struct points p = page_question.points;
    page_forget_cells();
    sorted.grid = (struct grid){axis_cut(0, 1, INFINITY, columns),
                                axis_cut(0, 1, INFINITY, rows)};
    sorted.cells = cells_sort(&sorted.grid, p);
    sorted.points = points_in_order(p, sorted.cells.point, 1);
    there = true;
}

uint32_t EXPORT(columns)(void)
{
    return sorted.grid.x.count;
}
uint32_t EXPORT(rows)(void)
{
    return sorted.grid.y.count;
}
double *EXPORT(column_border)(void)
{
    return sorted.grid.x.border;
}
double *EXPORT(row_border)(void)
{
    return sorted.grid.y.border;
}
uint32_t *EXPORT(start)(void)
{
    return sorted.cells.start;
}
uint32_t *EXPORT(point)(void)
{
    return sorted.cells.point;
}

// The cell of one point.
uint32_t EXPORT(cell_of)(uint32_t i)
{
    return grid_cell(&sorted.grid, page_question.points.x[i],
                     page_question.points.y[i]);
}

// Adds up counts from the left, as between counting and placing.
void EXPORT(scan_counts)(uint32_t *count, uint32_t m)
{
    cells_scan(count, m, 0);
}

// ---- the block of nine cells ----------------------------------------
static struct block block;
static struct query query;
static double margin;

// The nearest of point i among the nine cells around it.
uint32_t EXPORT(nearest_in_block)(uint32_t i)
{
    const struct points p = page_question.points;
    static struct counts counts;
    struct storage storage = {&sorted.grid, NULL, &sorted.cells, p,
                              NULL};
    query = query_at(p.x[i], p.y[i], i, &counts);
    block = block_of(&sorted.grid, p.x[i], p.y[i], 1);
    visit_block(STANDARD, page_question.space, &storage, &block,
                visit_indices, &query);
    margin = block_margin(&sorted.grid, &block, p.x[i], p.y[i]);
    return query.nearest;
}

double EXPORT(block_best2)(void)
{
    return query.best2;
}
double EXPORT(margin_of_block)(void)
{
    return margin;
}
uint32_t EXPORT(block_column)(void)
{
    return block.x.first;
}
uint32_t EXPORT(block_row)(void)
{
    return block.y.first;
}
uint32_t EXPORT(block_columns)(void)
{
    return block.x.count;
}
uint32_t EXPORT(block_rows)(void)
{
    return block.y.count;
}

// ---- eight queries and three spans ----------------------------------
// The batch of sorted point s: up to widest that follow each other in a
// row of cells, and the block around them. Returns how many they are.
uint32_t EXPORT(batch_from)(uint32_t s, uint32_t widest)
{
    const struct points p = sorted.points;
    const struct grid *grid = &sorted.grid;
    const uint32_t row = axis_cell(&grid->y, p.y[s]);
    uint32_t width = 1;
    while (width < widest && s + width < p.n &&
           axis_cell(&grid->y, p.y[s + width]) == row)
        width++;
    block = block_around(grid, row, axis_cell(&grid->x, p.x[s]),
                         axis_cell(&grid->x, p.x[s + width - 1]), 1);
    return width;
}

// The nearest of sorted point s among the candidates of its batch.
uint32_t EXPORT(nearest_in_batch)(uint32_t s)
{
    const struct points p = sorted.points;
    static struct counts counts;
    struct storage storage = {&sorted.grid, NULL, &sorted.cells, p,
                              sorted.cells.point};
    query = query_at(p.x[s], p.y[s], sorted.cells.point[s], &counts);
    visit_block(STANDARD, page_question.space, &storage, &block,
                visit_sorted, &query);
    margin = block_margin(&sorted.grid, &block, p.x[s], p.y[s]);
    return query.nearest;
}

// ---- the spiral -----------------------------------------------------
// The query comes first, so that a pointer to it is one to the record.
enum { MOST_CELLS = 4096 };

static struct recorder {
    struct spiral_query query;
    uint32_t count;
    uint32_t cell[MOST_CELLS], compared[MOST_CELLS];
    uint32_t nearest[MOST_CELLS]; // when the cell has been visited
} recorder;

INLINED void visit_and_record(const enum geometry geometry,
                              const struct map *map, uint32_t cell,
                              struct spiral_query *query)
{
    struct recorder *r = (struct recorder *)query;
    const uint64_t before = query->distances;
    visit_cell(geometry, map, cell, query);
    if (r->count == MOST_CELLS)
        return;
    r->cell[r->count] = cell;
    r->compared[r->count] = query->distances - before;
    r->nearest[r->count++] = query->nearest;
}

// Searches for the nearest of point i; returns how many cells that
// took.
uint32_t EXPORT(spiral_cells)(uint32_t i)
{
    struct map map = {&sorted.grid, &sorted.cells, page_question.points,
                      page_question.space};
    recorder.query = spiral_query_at(&map, i);
    recorder.count = 0;
    if (page_question.space.geometry == WRAPAROUND)
        spiral_nearest(WRAPAROUND, &map, visit_and_record,
                       &recorder.query);
    else
        spiral_nearest(STANDARD, &map, visit_and_record,
                       &recorder.query);
    return recorder.count;
}

uint32_t *EXPORT(visited_cell)(void)
{
    return recorder.cell;
}
uint32_t *EXPORT(visited_points)(void)
{
    return recorder.compared;
}
uint32_t *EXPORT(visited_nearest)(void)
{
    return recorder.nearest;
}

// ---- pack and scan --------------------------------------------------
uint32_t EXPORT(pack)(uint32_t *to, const uint32_t *from,
                      const uint8_t *keep, uint32_t n)
{
    return primitives(PORTABLE)->pack(to, from, keep, n);
}

uint32_t EXPORT(scan)(uint32_t *to, const uint32_t *from, uint32_t n)
{
    return primitives(PORTABLE)->scan(to, from, n, 0);
}

// ---- the corner trick -----------------------------------------------
// The furthest of all points where the trick looks for them.
void EXPORT(ask_one_corner)(void)
{
    search_one_corner(&page_question, &sorted, &page_answers);
}

double EXPORT(corner_radius2)(double x, double y)
{
    return circle_around(&sorted.grid, x, y).radius2;
}

// Whether the trick looks into this cell, for a query at (x, y).
bool EXPORT(corner_visits)(double x, double y, uint32_t column,
                           uint32_t row)
{
    struct circle circle = circle_around(&sorted.grid, x, y);
    return partly_outside(&sorted.grid, &circle, column, row);
}

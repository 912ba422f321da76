//> Search the rows of the plane
// What of a piece a query of the plane has to look at: chapter 11's
// rows and cells within reach, but for a list, and each of them once.
// Copies of it for each geometry.
#pragma once
#include "ch11-crowds/piece_rows.h"
#include "ch12-range-queries/plane_query.h"

//> Append a span of candidates
// Each is written at the end of the list, wanted or not. The end moves
// on only if it was wanted; if not, the next one is written over it.
INLINED size_t append_candidates(const struct space space,
                                 const struct plane_query *query,
                                 uint32_t begin, uint32_t end)
{
    const struct sorted *all = &query->index->pieces.sorted;
    const double *x = all->points.x, *y = all->points.y;
    const struct k_nearest_list *list = query->list;
    struct found *to = list->found + list->count;
    for (uint32_t s = begin; s < end; s++) {
        const uint32_t index = all->cells.point[s];
        const double d2 =
            closest2(space, x[s] - query->x, y[s] - query->y);
        *to = (struct found){d2, index};
        to += (d2 <= list->reach2) & (index != list->self);
    }
    return to - list->found;
}
//<

//> Count within a span
INLINED size_t count_within(const struct space space,
                            const struct plane_query *query,
                            uint32_t begin, uint32_t end)
{
    const struct sorted *all = &query->index->pieces.sorted;
    const double *x = all->points.x, *y = all->points.y;
    size_t count = query->list->count;
    for (uint32_t s = begin; s < end; s++)
        count += (closest2(space, x[s] - query->x, y[s] - query->y) <=
                  query->list->reach2) &
                 (all->cells.point[s] != query->list->self);
    return count;
}
//<

//> Take a span of sorted points
INLINED void take_span(const enum geometry geometry,
                       struct plane_query *query, uint32_t begin,
                       uint32_t end)
{
    struct k_nearest_list *list = query->list;
    struct space space = query->index->space;
    space.geometry = geometry;
    query->compared += end - begin;
    if (!list->found) {
        list->count = count_within(space, query, begin, end);
        return;
    }
    while (begin < end) {
        const uint32_t stop = begin + MIN(end - begin, MAX_APPENDED);
        if (list->count + MAX_APPENDED > list->room)
            keep_k_nearest(list);
        list->count = append_candidates(space, query, begin, stop);
        begin = stop;
    }
}
//<

//> Take cells of a row
// But not those of the block, which has been looked at.
INLINED void take_cells(const enum geometry geometry,
                        const struct piece *piece, uint32_t row,
                        struct cell_range cells,
                        struct plane_query *query)
{
    const uint32_t *start = piece->sorted.cells.start +
                            (size_t)row * piece->sorted.grid.x.count;
    const struct cell_block *block = &query->block;
    const bool known = query->has_block && piece == query->piece &&
                       row >= block->bottom && row <= block->top;
    const uint32_t begin = piece->begin + start[cells.first];
    const uint32_t end = piece->begin + start[cells.last + 1];
    if (!known) {
        take_span(geometry, query, begin, end);
        return;
    }
    const uint32_t from = piece->begin + start[block->left];
    const uint32_t to = piece->begin + start[block->right + 1];
    if (begin < from)
        take_span(geometry, query, begin, MIN(end, from));
    if (end > to)
        take_span(geometry, query, MAX(begin, to), end);
}
//<

//> Take what is within reach of a row
// With wraparound also of the query's images, from the left to the
// right; what one has looked at the next one leaves out.
INLINED void take_row(const enum geometry geometry,
                      const struct piece *piece, uint32_t row,
                      struct plane_query *query)
{
    const struct space space = query->index->space;
    const struct grid *grid = &piece->sorted.grid;
    const double across =
        reach(geometry, false, space.width, query->list->reach2,
              min_separation(geometry, space.height,
                             grid->y.border[row],
                             grid->y.border[row + 1], query->y)) +
        slack(geometry, query->x, space.width);
    const int images = geometry == WRAPAROUND;
    uint32_t next = 0;
    query->steps++;
    for (int k = -images; k <= images; k++) {
        struct cell_range cells;
        const double x = k ? query->x + k * space.width : query->x;
        if (!cells_within(&grid->x, x, across, &cells))
            continue;
        cells.first = MAX(cells.first, next);
        if (cells.first <= cells.last)
            take_cells(geometry, piece, row, cells, query);
        next = MAX(next, cells.last + 1);
    }
}
//<

//> Take what is within reach of a piece
INLINED void take_rows(const enum geometry geometry,
                       const struct piece *piece, struct box box,
                       struct plane_query *query)
{
    const struct space space = query->index->space;
    const struct axis *up = &piece->sorted.grid.y;
    const double above =
        reach(geometry, false, space.height, query->list->reach2,
              min_separation(geometry, space.width, box.left, box.right,
                             query->x)) +
        slack(geometry, query->y, space.height);
    const int images = geometry == WRAPAROUND;
    uint32_t next = 0;
    for (int k = -images; k <= images; k++) {
        struct cell_range rows;
        const double y = k ? query->y + k * space.height : query->y;
        if (!cells_within(up, y, above, &rows))
            continue;
        for (uint32_t row = MAX(rows.first, next); row <= rows.last;
             row++) {
            box.bottom = up->border[row];
            box.top = up->border[row + 1];
            if (box_bound(geometry, false, space, &box, query->x,
                          query->y) <= query->list->reach2)
                take_row(geometry, piece, row, query);
        }
        next = MAX(next, rows.last + 1);
    }
}
//<
//<

//> Query the cell array
// A cell between the first and the last that the range meets, along a
// coordinate, lies inside it there: numbers never fall from cell to
// cell. Only points of border cells are looked at, and only in the
// coordinates where the cell is at the border.
#include "ch12-range-queries/cell_array.h"
#include "common/min_max.h"

//> Hold the block of cells that a range meets
struct block {
    uint32_t first, last; // that it meets
    uint32_t inner, end;  // cells inner to end - 1 lie inside
};

struct cell_query {
    const struct cell_array *cells;
    const struct range *range;
    struct report *report;
    struct block block[MAX_DIMENSIONS];
};
//<

//> Find the block along a coordinate
static struct block block_along(const struct cell_array *cells, int k,
                                const struct range *range)
{
    struct block block = {cell_along(cells, k, range->low[k]),
                          cell_along(cells, k, range->high[k])};
    const bool from_start = range->low[k] <= cells->range.low[k];
    const bool to_end = range->high[k] >= cells->range.high[k];
    block.inner = block.first + !from_start;
    block.end = block.last + to_end;
    return block;
}
//<

//> Search a cell by halves
// The first place of the span whose number is not below, or with
// strictly, that is above the value.
static uint32_t place_of(const double *x, struct span span,
                         double value, bool strictly)
{
    while (span.begin < span.end) {
        const uint32_t middle =
            span.begin + (span.end - span.begin) / 2;
        if (x[middle] < value || (strictly && x[middle] == value))
            span.begin = middle + 1;
        else
            span.end = middle;
    }
    return span.begin;
}
//<

//> Search a row by its ends
static void search_row(const struct cell_query *query,
                       const uint32_t *start, unsigned axes)
{
    const struct sorted_points *sorted = &query->cells->sorted;
    const int k = sorted->points.d - 1;
    const struct block *block = &query->block[k];
    const struct span first = {start[block->first],
                               start[block->first + 1]},
                      last = {start[block->last],
                              start[block->last + 1]};
    const double *x = sorted->points.x[k];
    const uint32_t begin =
        place_of(x, first, query->range->low[k], false);
    const uint32_t end = place_of(x, last, query->range->high[k], true);
    if (begin >= end)
        return;
    if (axes)
        report_inside(sorted, begin, end,
                      (struct filter){query->range, axes},
                      query->report);
    else
        report_all(sorted, begin, end, query->report);
}
//<

//> Take a row of cells
// In a row that lies inside along all other coordinates, only the
// points of its ends are looked at.
static void take_row(const struct cell_query *query,
                     const uint32_t *start, unsigned axes)
{
    const struct sorted_points *sorted = &query->cells->sorted;
    const int k = sorted->points.d - 1;
    const struct block *block = &query->block[k];
    struct report *report = query->report;
    const uint32_t begin = start[block->first];
    const uint32_t end = start[block->last + 1];
    const struct filter filter = {query->range, axes | 1u << k};
    if (axes || block->inner >= block->end) {
        report_inside(sorted, begin, end, filter, report);
        return;
    }
    report_inside(sorted, begin, start[block->inner], filter, report);
    report_all(sorted, start[block->inner], start[block->end], report);
    report_inside(sorted, start[block->end], end, filter, report);
}
//<

//> Walk over the rows
// Chosen so far: a cell along each of the first k coordinates, which
// together are the row; axes is the set of those at the border.
static void walk(const struct cell_query *query, int k, uint32_t row,
                 unsigned axes)
{
    const struct cell_array *cells = query->cells;
    const struct block *block = &query->block[k];
    row *= cells->count[k];
    if (k == cells->sorted.points.d - 1) {
        query->report->steps += block->last - block->first + 1;
        if (cells->in_order)
            search_row(query, cells->start + row, axes);
        else
            take_row(query, cells->start + row, axes);
        return;
    }
    for (uint32_t j = block->first; j <= block->last; j++) {
        const bool inside = block->inner <= j && j < block->end;
        walk(query, k + 1, row + j, axes | (unsigned)!inside << k);
    }
}

void cell_array_query(const struct cell_array *cells,
                      const struct range *range, struct report *report)
{
    const int d = cells->sorted.points.d;
    struct cell_query query = {cells, range, report};
    if (!ranges_meet(&cells->range, range, d))
        return;
    for (int k = 0; k < d; k++) {
        query.block[k] = block_along(cells, k, range);
        if (query.block[k].first > query.block[k].last)
            return; // the range is empty
    }
    walk(&query, 0, 0, 0);
}
//<
//<

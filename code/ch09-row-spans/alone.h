//> Declare the search of those who ask alone
// The nearest neighbor of one point in the spans of its block: row by
// row, its own first, and another row only if that can have somebody as
// near as the nearest so far. If nobody in the block is nearer than all
// outside, the block is doubled.
#pragma once
#include "ch02-all-pairs/pair.h"
#include "ch04-cell-sort/block.h"
#include "ch04-cell-sort/sorted.h"
#include "common/count.h"

//> Hold one who asks
struct single {
    double x, y, best2;
    uint32_t self, nearest; // indices
};

// Ties go to the lowest index.
INLINED void single_keep(struct single *single, double near2,
                         uint32_t who)
{
    if (near2 < single->best2 ||
        (near2 == single->best2 && who < single->nearest)) {
        single->best2 = near2;
        single->nearest = who;
    }
}
//<

// Shows the sorted points begin .. end - 1 to one who asks.
typedef void meet_function(const enum geometry geometry,
                           struct space space,
                           const struct sorted *sorted, uint32_t begin,
                           uint32_t end, struct single *single);

//> Meet a row of the block
INLINED void meet_row(const enum geometry geometry, meet_function *meet,
                      struct space space, const struct sorted *sorted,
                      const struct reach *reach, uint32_t row,
                      struct single *single)
{
    const uint32_t columns = sorted->grid.x.count;
    const uint32_t *start = sorted->cells.start + row * columns;
    const uint32_t end = reach->first + reach->count;
    uint32_t begin = start[reach->first];
    uint32_t stop = start[end < columns ? end : columns];
    meet(geometry, space, sorted, begin, stop, single);
    COUNT(distances, stop - begin);
    if (end > columns) {
        meet(geometry, space, sorted, start[0], start[end - columns],
             single);
        COUNT(distances, start[end - columns] - start[0]);
    }
}
//<

//> Pass over a row
// Whether no point in it can be as near as the nearest so far.
INLINED bool row_is_far(const enum geometry geometry,
                        const struct axis *axis, uint32_t row,
                        const struct single *single)
{
    double below = single->y - axis->border[row + 1];
    double above = axis->border[row] - single->y;
    double gap = below > above ? below : above;
    if (geometry == WRAPAROUND) {
        double far = axis->border[row + 1] - single->y;
        double other = single->y - axis->border[row];
        double around = axis->period - (far > other ? far : other);
        gap = gap < around ? gap : around;
    }
    return gap > 0 && gap * gap > single->best2;
}
//<

//> Ask alone
INLINED struct single ask_alone(const enum geometry geometry,
                                meet_function *meet, const bool skip,
                                struct space space,
                                const struct sorted *sorted, uint32_t s)
{
    const struct grid *grid = &sorted->grid;
    struct single single = {sorted->points.x[s], sorted->points.y[s],
                            INFINITY, sorted->cells.point[s],
                            UINT32_MAX};
    const uint32_t home = axis_cell(&grid->y, single.y);
    for (uint32_t radius = 1;; radius *= 2) {
        struct block block = block_of(grid, single.x, single.y, radius);
        meet_row(geometry, meet, space, sorted, &block.x, home,
                 &single);
        for (uint32_t k = 0; k < block.y.count; k++) {
            uint32_t row = reach_cell(&grid->y, &block.y, k);
            if (row == home ||
                (skip && row_is_far(geometry, &grid->y, row, &single)))
                continue;
            meet_row(geometry, meet, space, sorted, &block.x, row,
                     &single);
        }
        double margin = block_margin(grid, &block, single.x, single.y);
        if (single.best2 < margin * margin ||
            block_covers(grid, &block))
            break;
    }
    COUNT(tasks, 1);
    return single;
}
//<
//<

//> Describe a block of cells
// A block: the cells around one cell, a number of them on each side,
// and a lower bound on the distance of every point outside of it. Along
// an axis, what lies outside is at most two intervals, one below the
// block and one above; with wraparound each can be reached in two ways.
#pragma once
#include "ch04-cell-sort/grid.h"
#include "common/min_max.h"
#include <stdbool.h>

//> Declare the block
struct interval {
    double low, high; // an empty one: INFINITY, -INFINITY
};

struct axis_range {
    uint32_t first, count; // its cells, counted on round the axis
    struct interval below, above; // what it lacks of the axis
};

struct block {
    struct axis_range x, y; // columns, rows
};
//<

//> Find the interval of some cells
// Of the cells begin .. end-1. It ends with the points, though cells
// may go on beyond them.
static inline struct interval interval_of(const struct axis *axis,
                                          int64_t begin, int64_t end)
{
    if (begin >= end)
        return (struct interval){INFINITY, -INFINITY};
    return (struct interval){
        axis->border[begin],
        MIN(axis->border[end], axis->border[axis->count])};
}
//<

//> Find the range around some cells
// The cells from .. to and radius more on either side; all cells if
// they are no more than these.
static inline struct axis_range axis_range(const struct axis *axis,
                                           uint32_t from, uint32_t to,
                                           uint32_t radius)
{
    const int64_t m = axis->count;
    int64_t first = (int64_t)from - radius;
    int64_t end = (int64_t)to + radius + 1;
    //> End the range at the edges
    if (axis->period == INFINITY) {
        first = first < 0 ? 0 : first;
        end = end > m ? m : end;
    }
    if (end - first >= m)
        first = 0, end = m;
    //<
    //> Name what the range lacks
    return (struct axis_range){
        first < 0 ? first + m : first, end - first,
        interval_of(axis, end > m ? end - m : 0, first),
        interval_of(axis, end, first < 0 ? first + m : m)};
    //<
}
//<

//> Go on round the axis
// Cell k of a range, 0 <= k < count.
static inline uint32_t range_cell(const struct axis *axis,
                                  const struct axis_range *range,
                                  uint32_t k)
{
    uint32_t cell = range->first + k;
    return cell < axis->count ? cell : cell - axis->count;
}
//<

//> Make a block of two ranges
// The block around the cells of a row from one column to another.
static inline struct block block_around(const struct grid *grid,
                                        uint32_t row, uint32_t from,
                                        uint32_t to, uint32_t radius)
{
    return (struct block){axis_range(&grid->x, from, to, radius),
                          axis_range(&grid->y, row, row, radius)};
}

// The block around the cell of a point.
static inline struct block block_of(const struct grid *grid, double x,
                                    double y, uint32_t radius)
{
    uint32_t column = axis_cell(&grid->x, x);
    return block_around(grid, axis_cell(&grid->y, y), column, column,
                        radius);
}
//<

//> Bound the separation from what lies outside
static inline double range_margin(const struct axis *axis,
                                  const struct axis_range *range,
                                  double x)
{
    double direct = MIN(x - range->below.high, range->above.low - x);
    double around =
        axis->period - MAX(x - range->below.low, range->above.high - x);
    return MIN(direct, around);
}
//<

//> Bound the distance from what lies outside
// No point outside the block is nearer to (x, y), in it, than this.
// INFINITY if the block has all cells.
static inline double block_margin(const struct grid *grid,
                                  const struct block *block, double x,
                                  double y)
{
    double across = range_margin(&grid->x, &block->x, x);
    double up = range_margin(&grid->y, &block->y, y);
    return MIN(across, up);
}

// Whether the block has all cells of the grid.
static inline bool block_covers(const struct grid *grid,
                                const struct block *block)
{
    return block->x.count == grid->x.count &&
           block->y.count == grid->y.count;
}
//<
//<

//> Reach around a cell
// A block: the cells around one cell, so and so many to either side,
// and how near a point outside of it can be. Along an axis, what lies
// outside is at most two stretches, one below the block and one above;
// with wraparound both can be reached in two ways.
#pragma once
#include "ch04-cell-sort/grid.h"
#include <stdbool.h>

struct stretch {
    double low, high; // an empty one: INFINITY, -INFINITY
};

struct reach {
    uint32_t first, count;       // its cells, counted on round the axis
    struct stretch below, above; // what it lacks of the axis
};

struct block {
    struct reach x, y; // columns, rows
};

static inline double least(double a, double b)
{
    return a < b ? a : b;
}

static inline double most(double a, double b)
{
    return a > b ? a : b;
}

//> Reach along an axis
// A stretch ends with the points, though cells may go on beyond them.
static inline struct stretch stretch_of(const struct axis *axis,
                                        int64_t begin, int64_t end)
{
    if (begin >= end)
        return (struct stretch){INFINITY, -INFINITY};
    return (struct stretch){
        axis->border[begin],
        least(axis->border[end], axis->border[axis->count])};
}

static inline struct reach axis_reach(const struct axis *axis,
                                      uint32_t from, uint32_t to,
                                      uint32_t radius)
{
    const int64_t m = axis->count;
    int64_t first = (int64_t)from - radius;
    int64_t end = (int64_t)to + radius + 1;
    if (axis->period == INFINITY) {
        first = first < 0 ? 0 : first;
        end = end > m ? m : end;
    }
    if (end - first >= m)
        first = 0, end = m;
    return (struct reach){
        first < 0 ? first + m : first, end - first,
        stretch_of(axis, end > m ? end - m : 0, first),
        stretch_of(axis, end, first < 0 ? first + m : m)};
}
//<

// The block around the cells of a row from one column to another.
static inline struct block block_around(const struct grid *grid,
                                        uint32_t row, uint32_t from,
                                        uint32_t to, uint32_t radius)
{
    return (struct block){axis_reach(&grid->x, from, to, radius),
                          axis_reach(&grid->y, row, row, radius)};
}

// The block around the cell of a point.
static inline struct block block_of(const struct grid *grid, double x,
                                    double y, uint32_t radius)
{
    uint32_t column = axis_cell(&grid->x, x);
    return block_around(grid, axis_cell(&grid->y, y), column, column,
                        radius);
}

// Cell k of a reach, 0 <= k < count.
static inline uint32_t reach_cell(const struct axis *axis,
                                  const struct reach *reach, uint32_t k)
{
    uint32_t cell = reach->first + k;
    return cell < axis->count ? cell : cell - axis->count;
}

//> Find the least separation from what lies outside
static inline double reach_margin(const struct axis *axis,
                                  const struct reach *reach, double x)
{
    double direct = least(x - reach->below.high, reach->above.low - x);
    double around = axis->period -
                    most(x - reach->below.low, reach->above.high - x);
    return least(direct, around);
}
//<

// No point outside the block is nearer to (x, y), in it, than this.
// INFINITY if the block has all cells.
static inline double block_margin(const struct grid *grid,
                                  const struct block *block, double x,
                                  double y)
{
    return least(reach_margin(&grid->x, &block->x, x),
                 reach_margin(&grid->y, &block->y, y));
}

// Whether the block has all cells of the grid.
static inline bool block_covers(const struct grid *grid,
                                const struct block *block)
{
    return block->x.count == grid->x.count &&
           block->y.count == grid->y.count;
}
//<

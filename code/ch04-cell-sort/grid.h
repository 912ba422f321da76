//> Declare the grid
// A grid over the points: equal cells in columns and rows, so that a
// point finds its cell by arithmetic. An axis cuts one coordinate into
// cells; a grid is two axes. Rounding decides, in the last bit, on
// which side of a border a point falls, so the grid says exactly where
// its cells begin: cell k holds the x with border[k] <= x <
// border[k+1], the last one also border[count]. A search that compares
// with borders then never errs.
#pragma once
#include "common/question.h"

//> Declare an axis
struct axis {
    uint32_t count; // of cells, >= 1
    double low;     // x is in cell (x - low) * scale,
    double scale;   // rounded down
    double *border; // border[0 .. count]
    double period;  // after which all repeats; INFINITY: nothing does
};
//<

//> Make a grid of two axes
struct grid {
    struct axis x, y; // columns, rows
};
//<

//> Find the cell on an axis
// For coordinates of the points that the axis was made for. Through a
// signed integer, which every vector unit can convert.
static inline uint32_t axis_cell(const struct axis *axis, double x)
{
    uint32_t k = (uint32_t)(int32_t)((x - axis->low) * axis->scale);
    return k < axis->count ? k : axis->count - 1;
}
//<

//> Find the cell of a point
// Cells are numbered row by row.
static inline uint32_t grid_cell(const struct grid *grid, double x,
                                 double y)
{
    return axis_cell(&grid->y, y) * grid->x.count +
           axis_cell(&grid->x, x);
}
//<

// Writes the cells of the points begin .. end - 1 to cell_id[0] and so
// on.
void find_cell_ids(const struct grid *grid, struct points points,
                   uint32_t begin, uint32_t end, uint32_t *cell_id);

static inline uint32_t grid_cells(const struct grid *grid)
{
    return grid->x.count * grid->y.count;
}

// How many cells hold c of n points each: n / c, but at least one, and
// so few that twice as many, once round and on, count in 32 bits.
static inline uint32_t cells_for(uint32_t n, double c)
{
    enum { MAX_CELLS = 1 << 30 };
    return fmax(1, fmin(round(n / c), MAX_CELLS));
}

//> Hold an extent
struct extent {
    double low, high;
};
//<

// Cuts the stretch from low to high, or if period is finite all of that
// from low on, into count cells; into one if it is too short or too
// long to be cut. Released with axis_free.
struct axis axis_cut(double low, double high, double period,
                     uint32_t count);
void axis_free(struct axis *axis);

// The least and the greatest of n >= 1 numbers, by so many threads.
struct extent extent_of(const double *values, uint32_t n, int threads);

// The extents of the question's points: those that it brings, or else
// found.
void box_of_points(const struct question *question, struct extent *x,
                   struct extent *y);

// A grid of nearly square cells over the points, about n / c of them
// and never more than n / c + 1, so that a cell holds c points on
// average; c > 0. Released with grid_free.
struct grid grid_fit(const struct question *question, double c);

// The same with its borders in a workspace, and not to be freed.
struct workspace;
struct grid grid_fit_in(struct workspace *workspace,
                        const struct question *question, double c);
void grid_free(struct grid *grid);
//<

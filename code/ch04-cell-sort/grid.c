//> Cut the plane into cells
// Fit a grid to the box of the points, and find to the last bit where
// each of its cells begins. O(n) for the box, a few steps a border.
#include "ch04-cell-sort/grid.h"
#include "common/allocate.h"
#include "common/min_max.h"
#include "common/workspace.h"
#include <assert.h>
#include <float.h>
#include <stdbool.h>
#include <stdlib.h>

//> Find where a cell begins
// The least x that lies in cell k or beyond. low + k / scale is right
// but for a few roundings; we halve from so much below it to as much
// above it.
static double begin_of(const struct axis *axis, double high, uint32_t k)
{
    double guess = axis->low + k / axis->scale;
    double error = 16 * DBL_EPSILON * fmax(fabs(axis->low), fabs(high));
    double before = fmax(axis->low, guess - error);
    double begin = fmin(high, guess + error);
    if (axis_cell(axis, begin) < k)
        return nextafter(high, INFINITY); // no point is there
    for (;;) {
        double middle = before + (begin - before) / 2;
        if (middle <= before || middle >= begin)
            return begin;
        if (axis_cell(axis, middle) < k)
            before = middle;
        else
            begin = middle;
    }
}
//<

//> Cut an axis
static struct axis cut(struct extent extent, double period,
                       uint32_t count, struct workspace *workspace)
{
    const double low = extent.low, high = extent.high;
    const size_t borders = (size_t)count + 1;
    double *border =
        workspace ? workspace_take(workspace, borders, sizeof *border)
                  : allocate(borders, sizeof *border);
    double width = isfinite(period) ? period : high - low;
    struct axis axis = {count, low, count / width, border, period};
    if (!(isfinite(width) && isfinite(axis.scale)))
        axis = (struct axis){1, 0, 0, border, period}; // any x * 0 is 0
    border[0] = low;
    for (uint32_t k = 1; k < axis.count; k++)
        border[k] = begin_of(&axis, high, k);
    border[axis.count] = high;
    return axis;
}
//<

struct axis axis_cut(double low, double high, double period,
                     uint32_t count)
{
    return cut((struct extent){low, high}, period, count, NULL);
}

void axis_free(struct axis *axis)
{
    free(axis->border);
    *axis = (struct axis){0};
}

// clang-format off
//> Find the box of the points
// Several at a time: each comparison waits for the last of its own
// lane only.
enum { LANES = 16 };

struct extent extent_of(const double *values, uint32_t n, int threads)
{
    double lowest[LANES], highest[LANES];
    for (int k = 0; k < LANES; k++)
        lowest[k] = highest[k] = values[0];
    const uint32_t whole = n - n % LANES;
    //> Keep sixteen lowest and sixteen highest
#pragma omp parallel for num_threads(threads) \
    reduction(min : lowest) reduction(max : highest)
    for (uint32_t i = 0; i < whole; i += LANES)
        for (int k = 0; k < LANES; k++) {
            double value = values[i + k];
            lowest[k] = MIN(value, lowest[k]);
            highest[k] = MAX(value, highest[k]);
        }
    //<
    for (uint32_t i = whole; i < n; i++) {
        lowest[0] = MIN(values[i], lowest[0]);
        highest[0] = MAX(values[i], highest[0]);
    }
    for (int k = 1; k < LANES; k++) {
        lowest[0] = MIN(lowest[k], lowest[0]);
        highest[0] = MAX(highest[k], highest[0]);
    }
    return (struct extent){lowest[0], highest[0]};
}
//<
// clang-format on

//> Share the cells between columns and rows
// Cells are square if columns / rows = width / height. A box that is
// flat, or too large for its own width, gets a single row or column.
static uint32_t columns_of(double width, double height, double cells)
{
    width = isfinite(width) ? width : 0;
    height = isfinite(height) ? height : 0;
    double columns = sqrt(cells) * sqrt(width) / sqrt(height);
    return isnan(columns) ? 1 : fmax(1, fmin(round(columns), cells));
}
//<

//> Take the box of the points
void box_of_points(const struct question *question, struct extent *x,
                   struct extent *y)
{
    const struct points p = question->points;
    const struct extent *box = question->box;
    *x = box ? box[0] : extent_of(p.x, p.n, question->threads);
    *y = box ? box[1] : extent_of(p.y, p.n, question->threads);
}
//<

//> Fit a grid to the points
struct grid grid_fit_in(struct workspace *workspace,
                        const struct question *question, double c)
{
    assert(c > 0 && "cells hold some points");
    const struct points p = question->points;
    const struct space space = question->space;
    struct extent x, y;
    box_of_points(question, &x, &y);
    bool wraps = space.geometry == WRAPAROUND;
    double width = wraps ? space.width : x.high - x.low;
    double height = wraps ? space.height : y.high - y.low;
    double cells = cells_for(p.n, c);
    uint32_t columns = columns_of(width, height, cells);
    uint32_t rows = fmax(1, floor(cells / columns));
    return (struct grid){
        cut(x, wraps ? width : INFINITY, columns, workspace),
        cut(y, wraps ? height : INFINITY, rows, workspace)};
}
//<

struct grid grid_fit(const struct question *question, double c)
{
    return grid_fit_in(NULL, question, c);
}

void grid_free(struct grid *grid)
{
    axis_free(&grid->x);
    axis_free(&grid->y);
}

//> Find the cell of every point
void find_cell_ids(const struct grid *grid, struct points points,
                   uint32_t begin, uint32_t end, uint32_t *cell_id)
{
    const struct grid g = *grid; // a copy: cell_id cannot change it
    const double *x = points.x + begin, *y = points.y + begin;
    for (uint32_t k = 0; k < end - begin; k++)
        cell_id[k] = grid_cell(&g, x[k], y[k]);
}
//<
//<

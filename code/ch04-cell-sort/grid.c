//> Cut the plane into cells
// See grid.h.
#include "ch04-cell-sort/grid.h"
#include "common/fail.h"
#include <assert.h>
#include <float.h>
#include <stdbool.h>
#include <stdlib.h>

//> Find where a cell begins
// The least x that lies in cell k or beyond. low + k / scale is right
// but for a few roundings; between its two neighbors we halve.
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
struct axis axis_cut(double low, double high, double period,
                     uint32_t count)
{
    double width = isfinite(period) ? period : high - low;
    struct axis axis = {count, low, count / width, NULL, period};
    if (!(isfinite(width) && isfinite(axis.scale)))
        axis = (struct axis){1, 0, 0, NULL, period}; // any x * 0 is 0
    axis.border = allocate((size_t)axis.count + 1, sizeof(double));
    axis.border[0] = low;
    for (uint32_t k = 1; k < axis.count; k++)
        axis.border[k] = begin_of(&axis, high, k);
    axis.border[axis.count] = high;
    return axis;
}
//<

void axis_free(struct axis *axis)
{
    free(axis->border);
    *axis = (struct axis){0};
}

//> Find the box of the points
// Several at a time: each comparison waits for the last of its own
// lane only.
enum { LANES = 16 };

static void extent(const double *values, uint32_t n, int threads,
                   double *low, double *high)
{
    double least[LANES], most[LANES];
    for (int k = 0; k < LANES; k++)
        least[k] = most[k] = values[0];
    const uint32_t whole = n - n % LANES;
#pragma omp parallel for num_threads(threads) \
    reduction(min : least) reduction(max : most)
    for (uint32_t i = 0; i < whole; i += LANES)
        for (int k = 0; k < LANES; k++) {
            double value = values[i + k];
            least[k] = value < least[k] ? value : least[k];
            most[k] = value > most[k] ? value : most[k];
        }
    for (uint32_t i = whole; i < n; i++) {
        least[0] = values[i] < least[0] ? values[i] : least[0];
        most[0] = values[i] > most[0] ? values[i] : most[0];
    }
    *low = least[0];
    *high = most[0];
    for (int k = 1; k < LANES; k++) {
        *low = fmin(*low, least[k]);
        *high = fmax(*high, most[k]);
    }
}
//<

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

//> Fit a grid to the points
struct grid grid_fit(const struct question *question, double c)
{
    assert(c > 0 && "cells hold some points");
    const struct points p = question->points;
    const struct space space = question->space;
    double left, right, bottom, top;
    extent(p.x, p.n, question->threads, &left, &right);
    extent(p.y, p.n, question->threads, &bottom, &top);
    bool wraps = space.geometry == WRAPAROUND;
    double width = wraps ? space.width : right - left;
    double height = wraps ? space.height : top - bottom;
    double cells = cells_for(p.n, c);
    uint32_t columns = columns_of(width, height, cells);
    uint32_t rows = fmax(1, floor(cells / columns));
    return (struct grid){
        axis_cut(left, right, wraps ? width : INFINITY, columns),
        axis_cut(bottom, top, wraps ? height : INFINITY, rows)};
}
//<

void grid_free(struct grid *grid)
{
    axis_free(&grid->x);
    axis_free(&grid->y);
}
//<

//> Sort points into cells of d dimensions
// Count, scan, place, as in chapter 4; to keep an order within cells,
// the points are taken in that order. n + m steps for m cells.
#include "ch12-range-queries/cell_array.h"
#include "ch04-cell-sort/cells.h"
#include "ch12-range-queries/radix_sort.h"
#include "common/allocate.h"
#include "common/min_max.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

//> Choose the cells
// All sides equal, as far as may be: a coordinate that is narrower than
// the side is not cut, and the others are cut the more. Logarithms keep
// products of many widths within what a double can be. They are
// rounded, so what is as wide as the side, or as a whole number of
// sides, but for a hair, is taken to be just that.
static const double HAIR = 1e-9;

static void choose_counts(struct cell_array *cells, double wanted)
{
    const int d = cells->sorted.points.d;
    double log_width[MAX_DIMENSIONS], log_side = INFINITY;
    bool cut[MAX_DIMENSIONS];
    int left = 0;
    for (int k = 0; k < d; k++) {
        const double width = cells->range.high[k] - cells->range.low[k];
        cut[k] = width > 0 && isfinite(width);
        log_width[k] = log(width);
        left += cut[k];
    }
    for (int before = d + 1; left > 0 && left < before;) {
        double sum = -log(MAX(wanted, 1));
        for (int k = 0; k < d; k++)
            sum += cut[k] ? log_width[k] : 0;
        log_side = sum / left;
        before = left;
        for (int k = 0; k < d; k++)
            if (cut[k] && log_width[k] <= log_side + HAIR) {
                cut[k] = false;
                left--;
            }
    }
    for (int k = 0; k < d; k++)
        cells->count[k] =
            cut[k] ? (uint32_t)exp(log_width[k] - log_side + HAIR) : 1;
}
//<

//> Find the cells of points in d dimensions
static uint32_t *cells_of(const struct cell_array *cells,
                          const struct point_set *points)
{
    uint32_t *cell = allocate(points->n, sizeof *cell);
    memset(cell, 0, points->n * sizeof *cell);
    for (int k = 0; k < points->d; k++)
        for (uint32_t i = 0; i < points->n; i++)
            cell[i] = cell[i] * cells->count[k] +
                      cell_along(cells, k, points->x[k][i]);
    return cell;
}
//<

//> Take the points by their last coordinate
static struct radix_record *by_last(const struct point_set *points)
{
    const uint32_t n = points->n;
    struct radix_record *record = allocate(n, sizeof *record);
    struct radix_record *room = allocate(n, sizeof *room);
    for (uint32_t i = 0; i < n; i++)
        record[i] = (struct radix_record){
            radix_key(points->x[points->d - 1][i]), i};
    radix_sort(record, n, 64, room);
    free(room);
    return record;
}
//<

//> Place the points by cell
// Points of a cell stay in the order in which they are taken.
static void place(struct cell_array *cells,
                  const struct point_set *points, uint32_t m)
{
    uint32_t *cell = cells_of(cells, points);
    uint32_t *next = cells->start + 1;
    struct radix_record *taken =
        cells->in_order ? by_last(points) : NULL;
    for (uint32_t i = 0; i < points->n; i++)
        next[cell[i]]++;
    cells_scan(next, m, 0);
    for (uint32_t r = 0; r < points->n; r++) {
        const uint32_t i = taken ? taken[r].point : r;
        cells->sorted.index[next[cell[i]]++] = i;
    }
    free(taken);
    free(cell);
}
//<

//> Find the borders of the slabs
static void find_borders(struct cell_array *cells, int k)
{
    const struct point_set *points = &cells->sorted.points;
    const uint32_t count = cells->count[k];
    double *max_up_to = allocate(count, sizeof *max_up_to);
    double *min_from = allocate(count, sizeof *min_from);
    for (uint32_t j = 0; j < count; j++) {
        max_up_to[j] = -INFINITY;
        min_from[j] = INFINITY;
    }
    for (uint32_t s = 0; s < points->n; s++) {
        const double x = points->x[k][s];
        const uint32_t j = cell_along(cells, k, x);
        max_up_to[j] = MAX(x, max_up_to[j]);
        min_from[j] = MIN(x, min_from[j]);
    }
    for (uint32_t j = 1; j < count; j++) {
        max_up_to[j] = MAX(max_up_to[j - 1], max_up_to[j]);
        min_from[count - 1 - j] =
            MIN(min_from[count - j], min_from[count - 1 - j]);
    }
    cells->max_up_to[k] = max_up_to;
    cells->min_from[k] = min_from;
}
//<

struct cell_array cell_array_make(const struct point_set *points,
                                  double per_cell, bool in_order)
{
    struct cell_array cells = {
        .sorted = sorted_points_allocate(points->n, points->d),
        .range = range_of(points, 0, points->n),
        .in_order = in_order,
        .per_cell = per_cell};
    choose_counts(&cells, points->n / per_cell);
    uint32_t m = 1;
    for (int k = 0; k < points->d; k++) {
        const double width = cells.range.high[k] - cells.range.low[k];
        m *= cells.count[k];
        cells.scale[k] =
            cells.count[k] > 1 ? cells.count[k] / width : 0;
    }
    cells.start = allocate((size_t)m + 1, sizeof *cells.start);
    memset(cells.start, 0, ((size_t)m + 1) * sizeof *cells.start);
    place(&cells, points, m);
    sorted_points_fill(&cells.sorted, points);
    for (int k = 0; k < points->d; k++)
        find_borders(&cells, k);
    return cells;
}

void cell_array_free(struct cell_array *cells)
{
    for (int k = 0; k < cells->sorted.points.d; k++) {
        free(cells->max_up_to[k]);
        free(cells->min_from[k]);
    }
    sorted_points_free(&cells->sorted);
    free(cells->start);
}

size_t cell_array_bytes(const struct cell_array *cells)
{
    size_t m = 1, slabs = 0;
    for (int k = 0; k < cells->sorted.points.d; k++) {
        m *= cells->count[k];
        slabs += cells->count[k];
    }
    return sorted_points_bytes(&cells->sorted) +
           (m + 1) * sizeof *cells->start + 2 * slabs * sizeof(double);
}
//<

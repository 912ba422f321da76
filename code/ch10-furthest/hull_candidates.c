//> Find the corners by their cells
// Leaves out whole cells, then finds the corners among what is left. A
// point that has one in each of the four directions is
// their mean, with some weights, and each of them is further away than
// a cell is wide and high: a surplus of the square of a cell's diagonal
// at least.
#include "ch10-furthest/hull_candidates.h"
#include "common/min_max.h"
#include <stdbool.h>
#include <string.h>

//> Hold a range of columns
// From the first to the last occupied column; none: first > last.
struct column_range {
    int64_t first, last;
};

static const struct column_range NONE = {INT64_MAX / 2, INT64_MIN / 2};
//<

//> See what is occupied
static struct column_range occupied(const struct sorted *sorted,
                                    uint32_t row)
{
    const struct axis *across = &sorted->grid.x;
    const uint32_t *start = sorted->cells.start + row * across->count;
    if (start[0] == start[across->count])
        return NONE;
    const double *x = sorted->points.x;
    return (struct column_range){
        axis_cell(across, x[start[0]]),
        axis_cell(across, x[start[across->count] - 1])};
}
//<

//> Join two ranges
// Both of them and all between.
static struct column_range join(struct column_range a,
                                struct column_range b)
{
    return (struct column_range){MIN(a.first, b.first),
                                 MAX(a.last, b.last)};
}
//<

//> Find what is enclosed
// In every row, the columns that have points two rows or more away
// and two columns or more, in each of the four directions.
static struct column_range *enclosed_columns(
    const struct sorted *sorted, struct workspace *workspace)
{
    const uint32_t rows = sorted->grid.y.count;
    struct column_range *enclosed =
        workspace_take(workspace, rows, sizeof *enclosed);
    struct column_range below = NONE, above = NONE;
    for (uint32_t row = 0; row < rows; row++) {
        if (row >= 2)
            below = join(below, occupied(sorted, row - 2));
        enclosed[row] = below;
    }
    for (uint32_t row = rows; row-- > 0;) {
        if (row + 2 < rows)
            above = join(above, occupied(sorted, row + 2));
        below = enclosed[row];
        enclosed[row] =
            (struct column_range){MAX(below.first, above.first) + 2,
                                  MIN(below.last, above.last) - 2};
    }
    return enclosed;
}
//<

//> Find the two spans of a row
// Of a row, what is before the enclosed columns, and what is after.
struct spans {
    uint32_t begin[2], end[2];
};

static struct spans spans_of(const struct sorted *sorted, uint32_t row,
                             struct column_range enclosed)
{
    const uint32_t columns = sorted->grid.x.count;
    const uint32_t *start = sorted->cells.start + row * columns;
    uint32_t first = columns, last = columns;
    if (enclosed.first <= enclosed.last)
        first = enclosed.first, last = enclosed.last + 1;
    return (struct spans){{start[0], start[last]},
                          {start[first], start[columns]}};
}
//<

//> Take all spans
static struct corners take_candidates(
    const struct sorted *sorted, const struct column_range *enclosed,
    struct workspace *workspace)
{
    const uint32_t rows = sorted->grid.y.count;
    uint32_t count = 0;
    for (uint32_t row = 0; row < rows; row++) {
        struct spans spans = spans_of(sorted, row, enclosed[row]);
        for (int k = 0; k < 2; k++)
            count += spans.end[k] - spans.begin[k];
    }
    struct corners found = corners_take(count, workspace);
    uint32_t at = 0;
    for (uint32_t row = 0; row < rows; row++) {
        struct spans spans = spans_of(sorted, row, enclosed[row]);
        for (int k = 0; k < 2; k++) {
            //> Take a span
            const uint32_t begin = spans.begin[k];
            count = spans.end[k] - begin;
            memcpy(found.points.x + at, sorted->points.x + begin,
                   count * sizeof(double));
            memcpy(found.points.y + at, sorted->points.y + begin,
                   count * sizeof(double));
            memcpy(found.point + at, sorted->cells.point + begin,
                   count * sizeof(uint32_t));
            at += count;
            //<
        }
    }
    return found;
}
//<

//> Make sure that a cell is wide enough
// Half of its diagonal, for what rounding did to its borders.
static bool cells_are_wide(const struct grid *grid)
{
    const struct axis *x = &grid->x, *y = &grid->y;
    double width = x->border[x->count] - x->border[0];
    double height = y->border[y->count] - y->border[0];
    return distance2(width / x->count, height / y->count) / 4 >
           CORNER_SURPLUS * distance2(width, height);
}
//<

//> Find the corners of sorted points
struct corners corners_of_sorted(const struct question *question,
                                 const struct sorted *sorted,
                                 struct workspace *workspace)
{
    if (!cells_are_wide(&sorted->grid))
        return corners_find(question, workspace);
    struct column_range *enclosed = enclosed_columns(sorted, workspace);
    return corners_among(take_candidates(sorted, enclosed, workspace),
                         question->threads, workspace);
}
//<
//<

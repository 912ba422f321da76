//> Search where the coursework looks
// The furthest point where the coursework looks for it: in all cells
// along the border of the grid, some 4 sqrt(n c) of n points, or in
// those that reach outside of a circle, some 4 c; c points in a cell.
// Both err where a corner of the grid has no points: for comparison
// only.
#include "ch10-furthest/coursework_furthest.h"
#include <stddef.h>

enum { POINTS_PER_CHUNK = 256 };

//> Hold a query for the furthest
struct far_query {
    double x, y;
    uint32_t self, furthest;  // indices
    double max2;              // squared distance to the furthest
    uint64_t cells, compared; // cells visited, points compared
};
//<

//> Visit a span of cells
// The cells first .. last of a row are one stretch of the points.
static void visit_span(const struct sorted *sorted, uint32_t row,
                       uint32_t first, uint32_t last,
                       struct far_query *query)
{
    const uint32_t *start =
        sorted->cells.start + (size_t)row * sorted->grid.x.count;
    for (uint32_t s = start[first]; s < start[last + 1]; s++) {
        uint32_t j = sorted->cells.point[s];
        double d2 = distance2(sorted->points.x[s] - query->x,
                              sorted->points.y[s] - query->y);
        if (j != query->self &&
            (d2 > query->max2 ||
             (d2 == query->max2 && j < query->furthest))) {
            query->max2 = d2;
            query->furthest = j;
        }
    }
    query->cells += last + 1 - first;
    query->compared += start[last + 1] - start[first];
}
//<

//> Visit the border
static void visit_border(const struct sorted *sorted,
                         struct far_query *query)
{
    uint32_t right = sorted->grid.x.count - 1;
    uint32_t top = sorted->grid.y.count - 1;
    visit_span(sorted, 0, 0, right, query);
    for (uint32_t row = 1; row < top; row++) {
        visit_span(sorted, row, 0, 0, query);
        if (right > 0)
            visit_span(sorted, row, right, right, query);
    }
    if (top > 0)
        visit_span(sorted, top, 0, right, query);
}
//<

//> Draw the circle of the corner trick
static double to_furthest_cell(const struct axis *axis, double x)
{
    uint32_t m = axis->count;
    double back = x - axis->border[0], on = axis->border[m] - x;
    return fmax(0, on > back ? axis->border[m - 1] - x
                             : x - axis->border[1]);
}

struct circle circle_around(const struct grid *grid, double x, double y)
{
    return (struct circle){x, y,
                           distance2(to_furthest_cell(&grid->x, x),
                                     to_furthest_cell(&grid->y, y))};
}
//<

//> Visit the ends of a row
// What is outside the circle is at the two ends of a row.
static bool visit_ends(const struct sorted *sorted,
                       const struct circle *circle, uint32_t row,
                       struct far_query *query)
{
    const struct grid *grid = &sorted->grid;
    uint32_t left = 0, right = grid->x.count;
    while (left < right && partly_outside(grid, circle, left, row))
        left++;
    while (right > left && partly_outside(grid, circle, right - 1, row))
        right--;
    if (left > 0)
        visit_span(sorted, row, 0, left - 1, query);
    if (right < grid->x.count)
        visit_span(sorted, row, right, grid->x.count - 1, query);
    return left > 0 || right < grid->x.count;
}
//<

//> Visit what is outside the circle
// From the lowest row up and from the highest row down, as long as
// a row has a cell that is partly outside.
static void visit_outside(const struct sorted *sorted,
                          struct far_query *query)
{
    struct circle circle =
        circle_around(&sorted->grid, query->x, query->y);
    uint32_t low = 0, high = sorted->grid.y.count;
    while (low < high && visit_ends(sorted, &circle, low, query))
        low++;
    while (high > low && visit_ends(sorted, &circle, high - 1, query))
        high--;
}
//<

//> Know a search that errs
typedef void far_visit(const struct sorted *sorted,
                       struct far_query *query);
//<

//> Visit for every query
static void search(const struct question *question,
                   const struct sorted *sorted, far_visit *visit,
                   struct answers *answers)
{
#pragma omp parallel num_threads(question->threads)
    {
        struct counts mine = {0};
#pragma omp for schedule(dynamic, POINTS_PER_CHUNK)
        for (uint32_t s = 0; s < sorted->points.n; s++) {
            uint32_t i = sorted->cells.point[s];
            struct far_query query = {.x = sorted->points.x[s],
                                      .y = sorted->points.y[s],
                                      .self = i,
                                      .furthest = NO_INDEX,
                                      .max2 = -1};
            visit(sorted, &query);
            answers->furthest[i] = query.furthest;
            answers->furthest2[i] = query.max2;
            mine.cells += query.cells;
            mine.distances += query.compared;
        }
        counts_add(question->counts, &mine);
    }
}
//<

void search_edge_cells(const struct question *question,
                       const struct sorted *sorted,
                       struct answers *answers)
{
    search(question, sorted, visit_border, answers);
}

void search_one_corner(const struct question *question,
                       const struct sorted *sorted,
                       struct answers *answers)
{
    search(question, sorted, visit_outside, answers);
}
//<

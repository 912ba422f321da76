//> Search where the coursework looks
// See border.h.
#include "ch10-furthest/border.h"
#include "ch04-cell-sort/lists.h"
#include "common/count.h"
#include <stddef.h>

#ifdef COUNTING
#define search_edge_cells counting_search_edge_cells
#define search_one_corner counting_search_one_corner
#endif

enum { POINTS_PER_TURN = 256 };

//> Hold a point that asks for the furthest
struct asking {
    double x, y;
    uint32_t self, furthest; // indices
    double best2;
    uint64_t cells, met; // looked at
};
//<

//> Look for the furthest in a span
// The cells first .. last of a row are one stretch of the points.
static void look_at_span(const struct sorted *sorted, uint32_t row,
                         uint32_t first, uint32_t last,
                         struct asking *asking)
{
    const uint32_t *start =
        sorted->cells.start + (size_t)row * sorted->grid.x.count;
    for (uint32_t s = start[first]; s < start[last + 1]; s++) {
        uint32_t j = sorted->cells.point[s];
        double d2 = distance2(sorted->points.x[s] - asking->x,
                              sorted->points.y[s] - asking->y);
        if (j != asking->self &&
            (d2 > asking->best2 ||
             (d2 == asking->best2 && j < asking->furthest))) {
            asking->best2 = d2;
            asking->furthest = j;
        }
    }
    asking->cells += last + 1 - first;
    asking->met += start[last + 1] - start[first];
}
//<

//> Look along the border
static void look_along_border(const struct sorted *sorted,
                              struct asking *asking)
{
    uint32_t right = sorted->grid.x.count - 1;
    uint32_t top = sorted->grid.y.count - 1;
    look_at_span(sorted, 0, 0, right, asking);
    for (uint32_t row = 1; row < top; row++) {
        look_at_span(sorted, row, 0, 0, asking);
        if (right > 0)
            look_at_span(sorted, row, right, right, asking);
    }
    if (top > 0)
        look_at_span(sorted, top, 0, right, asking);
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

//> Look at the ends of a row
// What is outside the circle is at the two ends of a row.
static bool look_at_ends(const struct sorted *sorted,
                         const struct circle *circle, uint32_t row,
                         struct asking *asking)
{
    const struct grid *grid = &sorted->grid;
    uint32_t left = 0, right = grid->x.count;
    while (left < right && partly_outside(grid, circle, left, row))
        left++;
    while (right > left && partly_outside(grid, circle, right - 1, row))
        right--;
    if (left > 0)
        look_at_span(sorted, row, 0, left - 1, asking);
    if (right < grid->x.count)
        look_at_span(sorted, row, right, grid->x.count - 1, asking);
    return left > 0 || right < grid->x.count;
}
//<

//> Look outside the circle
// From the lowest row up and from the highest row down, as long as
// there is something to see.
static void look_outside(const struct sorted *sorted,
                         struct asking *asking)
{
    struct circle circle =
        circle_around(&sorted->grid, asking->x, asking->y);
    uint32_t low = 0, high = sorted->grid.y.count;
    while (low < high && look_at_ends(sorted, &circle, low, asking))
        low++;
    while (high > low &&
           look_at_ends(sorted, &circle, high - 1, asking))
        high--;
}
//<

//> Let every point look there
typedef void look_far_function(const struct sorted *sorted,
                               struct asking *asking);

static void search(const struct question *question,
                   const struct sorted *sorted, look_far_function *look,
                   struct answers *answers)
{
#pragma omp parallel for num_threads(question->threads) \
    schedule(dynamic, POINTS_PER_TURN)
    for (uint32_t s = 0; s < sorted->points.n; s++) {
        uint32_t i = sorted->cells.point[s];
        struct asking asking = {sorted->points.x[s],
                                sorted->points.y[s],
                                i,
                                NOBODY,
                                -1,
                                0,
                                0};
        look(sorted, &asking);
        answers->furthest[i] = asking.furthest;
        answers->furthest2[i] = asking.best2;
        COUNT(cells, asking.cells);
        COUNT(distances, asking.met);
    }
}

void search_edge_cells(const struct question *question,
                       const struct sorted *sorted,
                       struct answers *answers)
{
    search(question, sorted, look_along_border, answers);
}

void search_one_corner(const struct question *question,
                       const struct sorted *sorted,
                       struct answers *answers)
{
    search(question, sorted, look_outside, answers);
}
//<
//<

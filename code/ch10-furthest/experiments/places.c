// From the middle of every cell in the lower half of a grid, how many
// cells the corner trick looks at.
#include "ch04-cell-sort/sorted.h"
#include "ch10-furthest/coursework_furthest.h"
#include "common/experiment.h"

enum { POINTS = 1000, PER_CELL = 2 };

static int cells_outside(const struct grid *grid, double x, double y)
{
    struct circle circle = circle_around(grid, x, y);
    int count = 0;
    for (uint32_t row = 0; row < grid->y.count; row++)
        for (uint32_t column = 0; column < grid->x.count; column++)
            count += partly_outside(grid, &circle, column, row);
    return count;
}

static double middle(const struct axis *axis, uint32_t k)
{
    return (axis->border[k] + axis->border[k + 1]) / 2;
}

int main(int argc, char **argv)
{
    experiment_begin(argc, argv);
    struct question question = uniform_question(STANDARD, POINTS, 1);
    struct sorted sorted = sorted_make(&question, PER_CELL);
    const struct grid *grid = &sorted.grid;
    for (uint32_t row = grid->y.count / 2; row-- > 0;)
        for (uint32_t column = 0; column < grid->x.count; column++)
            row_cells("%d%c",
                      cells_outside(grid, middle(&grid->x, column),
                                    middle(&grid->y, row)),
                      column + 1 < grid->x.count ? ' ' : '\n');
}

// Adds up what the searches of all points visit. The search counts by
// itself, here in the order of the cells.
#include "ch07-spiral/experiments/census.h"
#include "algorithms.h"
#include "ch07-spiral/spiral.h"

struct census take_census(const struct question *question, double c)
{
    const double n = question->points.n;
    struct counts counts = {0};
    struct question counted = *question;
    counted.counts = &counts;
    struct grid grid = grid_fit(question, c);
    struct cells cells = cells_sort(&grid, question->points);
    struct answers answers = answers_for(n, NEAREST);
    search_spiral(&counted, &grid, &cells, cells.point, &answers);
    struct census census = {n / grid_cells(&grid), counts.distances / n,
                            counts.cells / n};
    answers_free(&answers);
    cells_free(&cells);
    grid_free(&grid);
    return census;
}

//> Draw a few points in their cells
// Sorts a few points into cells and prints, for every place of the
// sorted order, the point, its coordinates, its cell and its column and
// row; then the borders of the grid.
//
//     portrait
#include "ch02-all-pairs/timing.h"
#include "ch04-cell-sort/cells.h"
#include "common/fail.h"
#include "common/report.h"
#include <stdio.h>

static void print_cells(const struct grid *grid, const uint32_t *start)
{
    const double *x = grid->x.border, *y = grid->y.border;
    const uint32_t columns = grid->x.count, rows = grid->y.count;
    for (uint32_t k = 0; k < columns * rows; k++) {
        uint32_t column = k % columns, row = k / columns;
        printf("cell\t%u\t0\t%.6f\t%.6f\t%u\t%u\n", k,
               (x[column] + x[column + 1]) / 2,
               (y[row] + y[row + 1]) / 2, k, start[k]);
    }
    for (uint32_t k = 0; k <= columns; k++)
        printf("column\t%u\t0\t%.6f\t0\t0\t0\n", k, x[k]);
    for (uint32_t k = 0; k <= rows; k++)
        printf("row\t%u\t0\t0\t%.6f\t0\t0\n", k, y[k]);
}

int main(void)
{
    enum { POINTS = 24 };
    fail_as("portrait");
    struct question question = uniform_question(STANDARD, POINTS, 8);
    struct points p = question.points;
    struct grid grid = grid_fit(&question, 2);
    struct cells cells = cells_sort(&grid, p);
    report_provenance(stdout);
    puts("kind\tplace\tpoint\tx\ty\tcell\tstart");
    for (uint32_t s = 0; s < POINTS; s++) {
        uint32_t i = cells.point[s],
                 k = grid_cell(&grid, p.x[i], p.y[i]);
        printf("point\t%u\t%u\t%.6f\t%.6f\t%u\t%u\n", s, i, p.x[i],
               p.y[i], k, cells.start[k]);
    }
    print_cells(&grid, cells.start);
    cells_free(&cells);
    grid_free(&grid);
    points_free(&question.points);
    return 0;
}
//<

// Sorts a few points into cells and prints, for every place of the
// sorted order, the point, its coordinates, its cell and its column and
// row; then the borders of the grid.
#include "ch04-cell-sort/cells.h"
#include "common/experiment.h"

static void print_cells(const struct grid *grid, const uint32_t *start)
{
    const double *x = grid->x.border, *y = grid->y.border;
    const uint32_t wide = grid->x.count, high = grid->y.count;
    for (uint32_t k = 0; k < wide * high; k++) {
        uint32_t column = k % wide, line = k / wide;
        row("cell\t%u\t0\t%.6f\t%.6f\t%u\t%u", k,
            (x[column] + x[column + 1]) / 2,
            (y[line] + y[line + 1]) / 2, k, start[k]);
    }
    uint32_t end = wide * high;
    row("end\t%u\t0\t0\t0\t%u\t%u", end, end, start[end]);
    for (uint32_t k = 0; k <= wide; k++)
        row("column\t%u\t0\t%.6f\t0\t0\t0", k, x[k]);
    for (uint32_t k = 0; k <= high; k++)
        row("row\t%u\t0\t0\t%.6f\t0\t0", k, y[k]);
}

int main(int argc, char **argv)
{
    enum { POINTS = 24 };
    struct experiment e = experiment_begin(argc, argv);
    struct question question = uniform_question(STANDARD, POINTS, 8);
    struct points p = question.points;
    struct grid grid = grid_fit(&question, 2);
    struct cells cells = cells_sort(&grid, p);
    print_header(&e, "kind place point x y cell start");
    for (uint32_t s = 0; s < POINTS; s++) {
        uint32_t i = cells.point[s],
                 k = grid_cell(&grid, p.x[i], p.y[i]);
        row("point\t%u\t%u\t%.6f\t%.6f\t%u\t%u", s, i, p.x[i], p.y[i],
            k, cells.start[k]);
    }
    print_cells(&grid, cells.start);
}

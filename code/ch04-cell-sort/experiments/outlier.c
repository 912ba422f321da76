// A hundred thousand points in the unit square, and one of them far out
// of it: how many cells there are if the side of a cell is fixed, and
// how many if the number of points in a cell is.
#include "ch04-cell-sort/grid.h"
#include "common/experiment.h"

int main(int argc, char **argv)
{
    enum { POINTS = 100000 };
    const double c = 2, side = sqrt(c / POINTS);
    experiment_begin(argc, argv);
    struct question question = uniform_question(STANDARD, POINTS, 1);
    row("one point at   cells of fixed side  their memory   our cells");
    for (double far = 1; far <= 1e6; far *= 100) {
        question.points.x[0] = question.points.y[0] = far;
        struct grid grid = grid_fit(&question, c);
        double cells = pow(ceil(far / side), 2);
        row("%12.0f  %20.0f  %9.3g GB  %10u", far, cells,
            cells * sizeof(uint32_t) / 1e9, grid_cells(&grid));
        grid_free(&grid);
    }
}

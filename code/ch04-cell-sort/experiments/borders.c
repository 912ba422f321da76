// Cuts the unit interval into 2, 3, ... cells and finds in three ways
// where each cell begins: k widths from the start, by dividing by the
// width, by multiplying with the number of cells, and by the axis that
// has searched for it.
//     borders [MOST]
#include "ch04-cell-sort/grid.h"
#include "common/experiment.h"

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t most = parameter(&e, "MOST", 1000, 2, 100000);
    uintmax_t borders = 0, divided = 0, multiplied = 0, exact = 0;
    for (uint32_t m = 2; m <= most; m++) {
        struct axis axis = axis_cut(0, 1, INFINITY, m);
        double width = 1.0 / m;
        for (uint32_t k = 1; k < m; k++) {
            double x = k * width;
            borders++;
            divided += (uint32_t)(x / width) != k;
            multiplied += (uint32_t)(x * m) != k;
            exact += axis_cell(&axis, axis.border[k]) != k;
        }
        axis_free(&axis);
    }
    row("borders                               %8ju\n"
        "in the wrong cell, x / width          %8ju\n"
        "in the wrong cell, x * cells          %8ju\n"
        "in the wrong cell, the axis's borders %8ju",
        borders, divided, multiplied, exact);
}

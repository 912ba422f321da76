// Prints, for the places of a fine grid over the unit square, how far
// they are from one point: plainly, to the closest image, and to the
// furthest image. An empty line ends a row of the grid.
#include "common/experiment.h"

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    const double x = 0.2, y = 0.3; // the point
    const int steps = 100;
    const struct space plain = {STANDARD, 1, 1};
    const struct space wrapped = {WRAPAROUND, 1, 1};
    print_header(&e, "x y standard closest furthest");
    for (int row = 0; row <= steps; row++, putchar('\n'))
        for (int column = 0; column <= steps; column++) {
            double px = (double)column / steps;
            double py = (double)row / steps;
            printf("%g\t%g\t%.6g\t%.6g\t%.6g\n", px, py,
                   sqrt(closest2(plain, x - px, y - py)),
                   sqrt(closest2(wrapped, x - px, y - py)),
                   sqrt(furthest2(wrapped, x - px, y - py)));
        }
}

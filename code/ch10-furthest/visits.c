//> Expect and count what the search from outside looks at
// Cells with points and distances for a point, in both geometries, of
// uniform points: expected where only one corner matters, or with
// wraparound far from any seam, and counted.
//
//     visits [MOST [SETS]]
#include "algorithms.h"
#include "ch02-all-pairs/timing.h"
#include "ch10-furthest/furthest_cells.h"
#include "common/argument.h"
#include "common/fail.h"
#include "common/report.h"

enum { PLACES = 64, REACH = 12 };

//> Expect the cells at a corner
// Of those seen in a direction (right, up), cells counted from the
// corner: row by row, each as long as nobody seen before is further
// than all that is in the cell. Those further are in a triangle, of
// which only the rows up to its own have been seen.
static double cells_at_corner(double c, double right, double up)
{
    double sum = 0, length = hypot(right, up);
    right /= length, up /= length;
    for (int row = 0; row < REACH; row++)
        for (int column = 0; column < REACH; column++) {
            double depth = column * right + row * up;
            double height = fmin(row + 1, depth / up);
            double seen =
                (depth * height - height * height * up / 2) / right;
            sum += exp(-c * seen);
        }
    return sum;
}
//<

//> Expect the cells around a point
// At (u, v) in its home, with wraparound: the nearer by the sum of the
// separations, the further. Those further than all that is in a cell
// are in a diamond, cut off above and below the rows seen.
static double separation(int k, double u)
{
    return k > 0 ? k - u : k < 0 ? u - k - 1 : 0;
}

static double cells_around(double c, double u, double v)
{
    double sum = 0;
    for (int row = -REACH; row <= REACH; row++) {
        double away = separation(row, v), up = 0, down = 0;
        for (int k = -REACH; k <= REACH; k++)
            if (separation(k, v) <= away) {
                up = fmax(up, k + 1 - v);
                down = fmax(down, v - k);
            }
        for (int column = -REACH; column <= REACH; column++) {
            double reach = separation(column, u) + away;
            double above = fmax(0, reach - up);
            double below = fmax(0, reach - down);
            sum += exp(-c * (2 * reach * reach - above * above -
                             below * below));
        }
    }
    return sum;
}
//<

//> Average over all places
static double cells_expected(enum geometry geometry, double c)
{
    double sum = 0;
    for (int i = 0; i < PLACES; i++)
        for (int j = 0; j < PLACES; j++) {
            double u = (i + 0.5) / PLACES, v = (j + 0.5) / PLACES;
            sum += geometry == STANDARD
                       ? cells_at_corner(c, (1 + u) / 2, (1 + v) / 2)
                       : cells_around(c, u, v);
        }
    return sum / PLACES / PLACES;
}
//<

//> Print what was expected and counted
// A cell without points is not looked at. With wraparound home is never
// empty, and a point there meets itself.
static void print_visits(enum geometry geometry, uint32_t n, int sets)
{
    const double c = POINTS_PER_FAR_CELL, all = (double)n * sets;
    const double home = geometry == WRAPAROUND ? 1 : 0;
    const double cells = cells_expected(geometry, c);
    struct counts sum = {0};
    struct answers answers = answers_for(n, FURTHEST);
    for (int set = 0; set < sets; set++) {
        struct question question =
            uniform_question(geometry, n, set + 1);
        struct counts counts = count_operations(
            find_algorithm("furthest-cells"), &question, &answers);
        sum.cells += counts.cells;
        sum.distances += counts.distances;
        points_free(&question.points);
    }
    printf("%s_visits_%u\t%u\t%d\t%.4g\t%.4g\t%.4g\t%.4g\t%.4g\n",
           home > 0 ? "wraparound" : "standard", n, n, sets, c,
           home + (cells - home) * (1 - exp(-c)), sum.cells / all,
           home + cells * c, sum.distances / all);
    fflush(stdout);
    answers_free(&answers);
}
//<

int main(int argc, char **argv)
{
    fail_as("visits", NULL);
    uint32_t most = argument(argc, argv, 1, "MOST", 10000, 1000, MANY);
    int sets = argument(argc, argv, 2, "SETS", 10, 1, MANY);
    report_provenance(stdout);
    puts("name\tn\tsets\tc\tcells_expected\tcells\tdistances_expected"
         "\tdistances");
    for (uint64_t n = 1000; n <= most; n *= 10)
        print_visits(STANDARD, n, sets);
    for (uint64_t n = 1000; n <= most; n *= 10)
        print_visits(WRAPAROUND, n, sets);
    return 0;
}
//<

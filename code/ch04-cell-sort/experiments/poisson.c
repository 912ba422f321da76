// Probabilities for points of a Poisson process, integrated in closed
// form or in small steps. Lengths are in sides of a cell.
#include "ch04-cell-sort/experiments/poisson.h"
#include <math.h>

static const double pi = 3.14159265358979323846;

//> Expect so many wrong neighbors
// 1 - q^2, where q is the integral of erf(sqrt(pi c) t) from 1 to 2.
double expected_wrong(double c)
{
    double k = sqrt(pi * c);
    double q = 2 * erf(2 * k) - erf(k) +
               (exp(-4 * k * k) - exp(-k * k)) / (k * sqrt(pi));
    return 1 - q * q;
}
//<

// What the blocks of radius 2, 4, 8, ... add, each with the chance that
// the one before was not enough: that no point is nearer than its
// border, which the point is t from, t in (0, 1/2) with density 4 (1 -
// 2t), and half a block further.
static double wider(double c, double (*amount)(double c, double empty,
                                               double side))
{
    enum { STEPS = 1000, RADII = 8 };
    double sum = 0;
    for (int step = 0; step < STEPS; step++) {
        double t = (step + 0.5) / (2 * STEPS);
        double weight = 4 * (1 - 2 * t) / (2 * STEPS);
        for (int r = 1; r < 1 << RADII; r *= 2) {
            double empty = pi * (r + t) * (r + t);
            sum +=
                weight * exp(-c * empty) * amount(c, empty, 4 * r + 1);
        }
    }
    return sum;
}

static double cells_in(double c, double empty, double side)
{
    (void)c, (void)empty;
    return side * side;
}

static double points_in(double c, double empty, double side)
{
    return c * (side * side - empty);
}

double expected_cells(double c)
{
    return 9 + wider(c, cells_in);
}

double expected_distances(double c)
{
    return 9 * c + wider(c, points_in);
}

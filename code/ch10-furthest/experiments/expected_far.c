// Expects how many cells the search from outside visits. Lengths are in
// sides of a cell; what is expected is averaged over a lattice of
// places in the query's cell.
#include "ch10-furthest/experiments/expected_far.h"
#include <math.h>

enum { PLACES = 64, REACH = 12 };

// Of those seen in a direction (right, up), cells counted from the
// corner: row by row, each as long as no point seen before is further
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

// At (u, v) in its own cell, with wraparound: the nearer by the sum of
// the separations, the further. Those further than all that is in a
// cell are in a diamond, cut off above and below the rows seen.
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

double expected_outside(enum geometry geometry, double c)
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

//> Expect what is found far away
// See expected_far.h.
#include "ch10-furthest/expected_far.h"
#include <math.h>

//> Expect cells near a corner
// The corner is seen in a direction of this slope. Beyond the furthest
// point a triangle is cut off from the corner, in which 1 point is
// expected, so that it is larger than a with probability exp(-n a).
// Cell (j, k) from the corner is looked at if the triangle reaches it.
static double cells_near_corner(double slope, double c)
{
    enum { MOST = 64 };
    double sum = 0;
    for (int j = 0; j < MOST; j++)
        for (int k = 0; k < MOST; k++) {
            double reach = j + k * slope;
            sum += exp(-c * reach * reach / (2 * slope));
        }
    return sum;
}

// The corner is between half the square and all of it away, on both
// axes.
static double average_over_square(double c)
{
    enum { STEPS = 40 };
    double sum = 0;
    for (int a = 0; a < STEPS; a++)
        for (int b = 0; b < STEPS; b++)
            sum += cells_near_corner(
                (STEPS + a + 0.5) / (STEPS + b + 0.5), c);
    return sum / (STEPS * STEPS);
}
//<

//> Expect cells around a point
// With wraparound the furthest has the least sum of separations s:
// nobody is in a diamond of area 2 s^2. Its own cell, those in its row
// and column, and the rest.
double expected_outside(enum geometry geometry, double c)
{
    if (geometry == STANDARD)
        return average_over_square(c);
    return 1 + 2 * sqrt(acos(-1) / (2 * c)) + 1 / c;
}
//<
//<

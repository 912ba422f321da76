// What a spiral search costs on average, from the probability that
// cells are empty. Lengths are in cells, and the cell of the query is
// the unit square, with the query at (u, v).
#include "ch07-spiral/experiments/expected.h"
#include <math.h>
#include <stdlib.h>

// Further layers are never visited, unless c is far below 1; and the
// steps of the integral.
enum { LAYERS = 8, STEPS = 64 };

//> Cut a quarter disc to a box
// Area of the points within r of a corner of an a by b box, in the box.
static double quarter(double a, double b, double r)
{
    a = fmin(a, r), b = fmin(b, r);
    double from = sqrt(r * r - b * b); // where the arc comes down
    if (a <= from)
        return a * b;
    double end = a * sqrt(r * r - a * a) + r * r * asin(a / r);
    double begin = from * b + r * r * asin(from / r);
    return from * b + (end - begin) / 2;
}
//<

//> Cut a disc to a layer
// The part of the disc of radius r around (u, v) in layers 0 to k.
static double disc_in_block(double u, double v, double r, int k)
{
    if (k < 0 || r == 0)
        return 0;
    double west = k + u, east = k + 1 - u;
    double south = k + v, north = k + 1 - v;
    return quarter(west, south, r) + quarter(east, south, r) +
           quarter(west, north, r) + quarter(east, north, r);
}

static double disc_in_layer(double u, double v, double r, int k)
{
    return disc_in_block(u, v, r, k) - disc_in_block(u, v, r, k - 1);
}
//<

static double cells_in_block(int k)
{
    return k < 0 ? 0 : (2.0 * k + 1) * (2 * k + 1);
}

//> Find the gap to a column
// From u, in column 0, to column dx.
static double gap(double u, int dx)
{
    return dx > 0 ? dx - u : dx < 0 ? u - dx - 1 : 0;
}
//<

//> Find the probability of a visit after layer k
// That phase one ends with layer k, and phase two visits a cell further
// out whose gap is d: no point in the layers before k, none nearer than
// d in layer k, but some point in it.
static double visit_after(double c, double u, double v, double d, int k)
{
    double before = cells_in_block(k - 1);
    double layer = cells_in_block(k) - before;
    return exp(-c * before) *
           (exp(-c * disc_in_layer(u, v, d, k)) - exp(-c * layer));
}
//<

//> Average over the places in a cell
// Phase one visits the cell, in layer m, if all layers before are
// empty. If it ended with one of these, phase two may.
double expected_visits(double c, int dx, int dy)
{
    int m = abs(dx) > abs(dy) ? abs(dx) : abs(dy);
    double sum = 0;
    for (int place = 0; place < STEPS * STEPS; place++) {
        double u = (place % STEPS + 0.5) / STEPS;
        double v = (place / STEPS + 0.5) / STEPS;
        double d = fmax(gap(u, dx), gap(v, dy));
        for (int k = 0; k < m; k++)
            if (d < (k + 1) * sqrt(2)) // as far as a point of layer k
                sum += visit_after(c, u, v, d, k);
    }
    return sum / (STEPS * STEPS) + exp(-c * cells_in_block(m - 1));
}
//<

//> Add up the cells
// One side of every layer, four times.
struct expected expected_spiral(double c)
{
    double cells = 1;
    for (int m = 1; m <= LAYERS; m++)
        for (int d = -m; d < m; d++)
            cells += 4 * expected_visits(c, m, d);
    return (struct expected){cells, c * cells};
}
//<

// As the report does.
double expected_printed(double c)
{
    double sum = 9 * c * (1 - exp(-c));
    for (int k = 1; k <= 7; k++)
        sum += 25 * c * exp(-k * c);
    return sum;
}

// Layer m is visited unless a layer before m - 1 has a point.
double expected_one_more(double c)
{
    double cells = 9;
    for (int m = 2; m <= LAYERS; m++)
        cells += 8 * m * exp(-c * cells_in_block(m - 2));
    return c * cells;
}

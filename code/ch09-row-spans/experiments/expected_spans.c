// Expects the candidates and the exact queries of a batch. Lengths are
// in sides of a cell. In a row of cells the gaps between points are
// exponential, with mean 1/c.
#include "ch09-row-spans/experiments/expected_spans.h"
#include <math.h>

// Eight points have seven gaps, 1/c cells long; the block ends a column
// beyond, and the columns are begun and ended where cells are. The
// middle row has the eight and what 3 cells hold, the other two what
// 7/c + 3 hold.
double expected_candidates(double c)
{
    return 22 + 9 * c;
}

// The probability that k gaps are together longer than t.
static double gaps_exceed(double c, int k, double t)
{
    double term = exp(-c * t), sum = 0;
    for (int i = 0; i < k; i++) {
        sum += term;
        term *= c * t / (i + 1);
    }
    return t < 0 ? 1 : sum;
}

// That the column's rest and k gaps are.
static double end_exceeds(double c, int k, double t)
{
    enum { PLACES = 64 };
    double sum = 0;
    for (int place = 0; place < PLACES; place++)
        sum += gaps_exceed(c, k, t - (place + 0.5) / PLACES);
    return sum / PLACES;
}

// The probability that lane's margin exceeds r >= 1.
static double margin_exceeds(double c, int lane, double r)
{
    return fmax(0, 3 - 2 * r) * end_exceeds(c, lane, r - 1) *
           end_exceeds(c, 7 - lane, r - 1);
}

static double expected_outside(double c)
{
    enum { STEPS = 200, LANES = 8 };
    double sum = 0;
    for (int lane = 0; lane < LANES; lane++) {
        double before = 1;
        for (int step = 1; step <= STEPS; step++) {
            double r = 1 + 0.5 * step / STEPS;
            double after = margin_exceeds(c, lane, r);
            double middle = r - 0.25 / STEPS;
            sum += (before - after) * exp(-c * M_PI * middle * middle);
            before = after;
        }
    }
    return sum / LANES;
}

// The squared distances of the two nearest differ by less than 2^-12 of
// the smaller with about this probability.
double expected_exact(double c)
{
    return expected_outside(c) + 0x1p-12;
}

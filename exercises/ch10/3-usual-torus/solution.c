// Rows outward from the antipode's, in a row the cells outward from its
// column, and no look at a row or cell that cannot reach as far as the
// best so far.
#include "exercise.h"
#include <math.h>

//- solution
// The k-th of n cells around a ring, outward from the first: one step
// to the right, one to the left, two to the right ...
static uint32_t outward(uint32_t first, uint32_t k, uint32_t n)
{
    uint32_t step = (k + 1) / 2;
    return (first + (k % 2 ? step : n - step)) % n;
}

static double around(double d, double n)
{
    d = fabs(d);
    return d < n - d ? d : n - d;
}

// How far cell k of n, from k to k + 1, reaches from x, on a ring.
static double reach(double x, uint32_t k, uint32_t n)
{
    double antipode = fmod(x + n / 2.0, n);
    if (antipode >= k && antipode <= k + 1.0)
        return n / 2.0;
    return fmax(around(k - x, n), around(k + 1.0 - x, n));
}

//- starter
//- end
uint32_t furthest_on_torus(struct box box, double x, double y)
{
    //- solution
    uint32_t best = UINT32_MAX;
    double best2 = -1, half = box.columns / 2.0;
    uint32_t middle = fmod(x + half, box.columns);
    uint32_t top = fmod(y + box.rows / 2.0, box.rows);
    for (uint32_t r = 0; r < box.rows; r++) {
        uint32_t row = outward(top, r, box.rows);
        double dy = reach(y, row, box.rows);
        if (half * half + dy * dy < best2)
            continue;
        for (uint32_t c = 0; c < box.columns; c++) {
            uint32_t column = outward(middle, c, box.columns);
            double dx = reach(x, column, box.columns);
            if (dx * dx + dy * dy < best2)
                continue;
            struct span span = look(column, row);
            for (uint32_t s = span.begin; s < span.end; s++) {
                double d2 = measure(s);
                if (d2 > best2 || (d2 == best2 && s < best)) {
                    best = s;
                    best2 = d2;
                }
            }
        }
    }
    return best;
    //- starter
    // // Your turn: this is the last point in the antipode's cell.
    // uint32_t column = fmod(x + box.columns / 2.0, box.columns);
    // uint32_t row = fmod(y + box.rows / 2.0, box.rows);
    // return look(column, row).end - 1;
    //- end
}

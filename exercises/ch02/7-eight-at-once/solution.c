// The nearest distances to another set: eight queries in eight lanes,
// and every candidate is shown to all of them. No lane waits for
// another, and nothing is combined.
#include "common/geometry.h"
#include "exercise.h"

//- solution
enum { LANES = 8 };

static void sweep(const double *x, const double *y, struct points to,
                  double *nearest2)
{
    double qx[LANES], qy[LANES], best[LANES];
    for (int l = 0; l < LANES; l++) {
        qx[l] = x[l];
        qy[l] = y[l];
        best[l] = INFINITY;
    }
    for (uint32_t j = 0; j < to.n; j++) {
        double cx = to.x[j], cy = to.y[j];
#pragma omp simd
        for (int l = 0; l < LANES; l++) {
            double d2 = distance2(cx - qx[l], cy - qy[l]);
            best[l] = d2 < best[l] ? d2 : best[l];
        }
    }
    for (int l = 0; l < LANES; l++)
        nearest2[l] = best[l];
}

//- starter
//- end
void nearest_in(struct points from, struct points to, double *nearest2)
{
    //- solution
    uint32_t i = 0;
    for (; i + LANES <= from.n; i += LANES)
        sweep(from.x + i, from.y + i, to, nearest2 + i);
    if (i == from.n)
        return;
    double x[LANES], y[LANES], best[LANES];
    for (uint32_t l = 0; l < LANES; l++) { // the last one stands in
        uint32_t q = i + l < from.n ? i + l : from.n - 1;
        x[l] = from.x[q];
        y[l] = from.y[q];
    }
    sweep(x, y, to, best);
    for (uint32_t l = 0; i + l < from.n; l++)
        nearest2[i + l] = best[l];
    //- starter
    // // Your turn. So far: the distance to the first point.
    // for (uint32_t i = 0; i < from.n; i++)
    //     nearest2[i] = distance2(to.x[0] - from.x[i],
    //                             to.y[0] - from.y[i]);
    //- end
}

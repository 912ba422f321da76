// Adds a generous margin, a thousandth of all that there is.
// expect: 4 of 10
#include "exercise.h"
#include <math.h>

struct float_box capture(const struct moving corner[3], double reach)
{
    struct float_box box;
    for (int k = 0; k < 3; k++) {
        double low = corner[0].begin[k], high = low;
        for (int c = 0; c < 3; c++) {
            low = fmin(low, fmin(corner[c].begin[k], corner[c].end[k]));
            high =
                fmax(high, fmax(corner[c].begin[k], corner[c].end[k]));
        }
        const double margin =
            1e-3 * (fabs(low) + fabs(high) + reach) + reach;
        box.low[k] = (float)(low - margin);
        box.high[k] = (float)(high + margin);
    }
    return box;
}

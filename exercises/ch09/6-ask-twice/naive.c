// Computes all of them again.
// expect: 1 of 10
#include "exercise.h"
#include <math.h>

struct found filter(const struct candidates *candidates, float x,
                    float y, float *scratch)
{
    struct found found = {UINT32_MAX, INFINITY};
    (void)x, (void)y, (void)scratch;
    for (uint32_t s = 0; s < candidates->n; s++) {
        uint32_t j = candidates->index[s];
        double d2 = exact(s);
        if (d2 < found.nearest2 ||
            (d2 == found.nearest2 && j < found.nearest))
            found = (struct found){j, d2};
    }
    return found;
}

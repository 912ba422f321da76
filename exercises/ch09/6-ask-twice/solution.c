// In single precision first. Each of these distances is wrong by less
// than 2^-23 (exercise 9.5), so the nearest is among those that exceed
// the smallest by 2^-22 or less. They are computed again.
#include "exercise.h"
#include <math.h>

struct found filter(const struct candidates *candidates, float x,
                    float y, float *scratch)
{
    //- solution
    float least2 = INFINITY;
    for (uint32_t s = 0; s < candidates->n; s++) {
        float dx = candidates->x[s] - x, dy = candidates->y[s] - y;
        scratch[s] = dx * dx + dy * dy;
        least2 = scratch[s] < least2 ? scratch[s] : least2;
    }
    double limit = sqrt(least2) + 0x1p-22;
    struct found found = {UINT32_MAX, INFINITY};
    for (uint32_t s = 0; s < candidates->n; s++) {
        if (scratch[s] > limit * limit)
            continue;
        uint32_t j = candidates->index[s];
        double d2 = exact(s);
        if (d2 < found.nearest2 ||
            (d2 == found.nearest2 && j < found.nearest))
            found = (struct found){j, d2};
    }
    return found;
    //- starter
    // // Your turn: so far none is computed a second time.
    // struct found found = {UINT32_MAX, INFINITY};
    // for (uint32_t s = 0; s < candidates->n; s++) {
    //     float dx = candidates->x[s] - x, dy = candidates->y[s] - y;
    //     scratch[s] = dx * dx + dy * dy;
    //     if (scratch[s] < found.nearest2)
    //         found = (struct found){candidates->index[s], scratch[s]};
    // }
    // return found;
    //- end
}

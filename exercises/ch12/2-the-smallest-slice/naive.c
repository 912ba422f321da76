// Walks over all places of all coordinates.
// expect: 4 of 10
#include "exercise.h"

struct axis_slice smallest_slice(uint32_t n, int d, const double *low,
                                 const double *high)
{
    struct axis_slice best = {-1, 0, n};
    for (int axis = 0; axis < d; axis++) {
        uint32_t begin = 0, end = 0;
        for (uint32_t place = 0; place < n; place++) {
            begin += number_at(axis, place) < low[axis];
            end += number_at(axis, place) <= high[axis];
        }
        if (best.axis < 0 || end - begin < best.end - best.begin)
            best = (struct axis_slice){axis, begin, end};
    }
    return best;
}

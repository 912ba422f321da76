// Two searches by halves for each coordinate.
#include "exercise.h"

//- solution
// The first place whose number is at least the value, or above it.
static uint32_t place_of(int axis, uint32_t n, double value, int above)
{
    uint32_t low = 0, high = n;
    while (low < high) {
        const uint32_t middle = low + (high - low) / 2;
        const double number = number_at(axis, middle);
        if (number < value || (above && number == value))
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}
//- starter
//- end

struct axis_slice smallest_slice(uint32_t n, int d, const double *low,
                                 const double *high)
{
    //- solution
    struct axis_slice best = {-1, 0, n};
    for (int axis = 0; axis < d; axis++) {
        const uint32_t begin = place_of(axis, n, low[axis], 0);
        const uint32_t end = place_of(axis, n, high[axis], 1);
        if (best.axis < 0 || end - begin < best.end - best.begin)
            best = (struct axis_slice){axis, begin, end};
    }
    return best;
    //- starter
    // // Your turn: so far it takes all places of the first coordinate.
    // (void)d, (void)low, (void)high;
    // return (struct axis_slice){0, 0, n};
    //- end
}

// How many numbers lie in an interval: those below its end without
// those below its beginning. Only in the bin of a bound do we look.
#include "exercise.h"

//- solution
static uint32_t count_below(const struct bins *bins, double x)
{
    if (x <= bins->border[0])
        return 0;
    if (x > bins->border[bins->count])
        return bins->start[bins->count];
    uint32_t k = bin_of(bins, x);
    uint32_t below = bins->start[k];
    if (x == bins->border[k])
        return below; // nothing in this bin is less
    for (uint32_t s = bins->start[k]; s < bins->start[k + 1]; s++)
        below += look(s) < x;
    return below;
}

//- starter
//- end
uint32_t count_between(const struct bins *bins, double a, double b)
{
    //- solution
    return a < b ? count_below(bins, b) - count_below(bins, a) : 0;
    //- starter
    // // Your turn: this counts whole bins only.
    // return bins->start[bin_of(bins, b)] -
    //        bins->start[bin_of(bins, a)];
    //- end
}

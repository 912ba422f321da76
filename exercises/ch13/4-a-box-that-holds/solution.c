// One step outward in double precision, for the subtraction, and then
// outward to the next number of single precision.
#include "exercise.h"
#include <math.h>

//- solution
// A float below the real number x - reach.
static float below(double x, double reach)
{
    const double safe = nextafter(x - reach, -INFINITY);
    const float nearest = (float)safe;
    return nearest <= safe ? nearest : nextafterf(nearest, -INFINITY);
}

//- starter
//- end
struct float_box capture(const struct moving corner[3], double reach)
{
    struct float_box box;
    for (int k = 0; k < 3; k++) {
        //- solution
        double least = INFINITY, most = -INFINITY;
        for (int c = 0; c < 3; c++) {
            const double a = corner[c].begin[k], b = corner[c].end[k];
            least = fmin(least, fmin(a, b));
            most = fmax(most, fmax(a, b));
        }
        box.low[k] = below(least, reach);
        box.high[k] = -below(-most, reach);
        //- starter
        // // Your turn: so far it holds one corner.
        // const struct moving *c = &corner[0];
        // box.low[k] = (float)fmin(c->begin[k], c->end[k]);
        // box.high[k] = (float)fmax(c->begin[k], c->end[k]);
        // (void)reach;
        //- end
    }
    return box;
}

// Powers of a number less than one half: each cut takes off one.
#include "exercise.h"

void go_deep(double *x, uint32_t n)
{
    //- solution
    double power = 1;
    for (uint32_t k = 0; k < n; k++) {
        x[k] = power;
        power *= 0.49;
    }
    //- starter
    // // Your turn: so far the depth is the logarithm of n.
    // for (uint32_t k = 0; k < n; k++)
    //     x[k] = (double)k / n;
    //- end
}

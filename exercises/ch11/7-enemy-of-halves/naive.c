// Powers of one half.
// expect: 3 of 10
#include "exercise.h"

void go_deep(double *x, uint32_t n)
{
    double power = 1;
    for (uint32_t k = 0; k < n; k++) {
        x[k] = power;
        power /= 2;
    }
}

//> Subtract with the multipliers
// Many processors add in one unit and multiply in another, and have a
// fused multiply-add that does both in the multiplier with a single
// rounding. a * 1 - b is then a - b to the last bit, and leaves the
// adder free. Where there is no such instruction, we subtract.
#pragma once
#include <math.h>

// The multiplier's 1. A compiler that saw it would subtract.
static const volatile double unit = 1;

static inline double subtract_fused(double a, double b, double one)
{
#if defined __FMA__ || defined __ARM_FEATURE_FMA
    return fma(a, one, -b);
#else
    (void)one;
    return a - b;
#endif
}
//<

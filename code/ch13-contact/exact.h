//> Declare the exact orientations
// On which side of a plane, or of a line, is a point? The sign of a
// determinant, decided exactly: in floating point where that is beyond
// doubt, otherwise in expansions, sums of doubles without rounding
// (Dekker 1971, Shewchuk 1997). Some 30 operations, rarely thousands.
//
// The rule for callers: every coordinate is 0 or, without its sign,
// between MIN_EXACT and MAX_EXACT. Then no product of three vanishes or
// overflows.
#pragma once
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

//> Bound what can be decided exactly
static const double MIN_EXACT = 0x1p-280, MAX_EXACT = 0x1p+280;

// Whether n coordinates keep to the rule; a NaN does not.
bool within_exact_bounds(const double *x, size_t n);
//<

//> Declare which side a point is on
// 1 if d is where a, b, c are seen to turn left, on the side to which
// (b - a) x (c - a) points; -1 if it is on the other; 0 if all four lie
// in a plane. Adds 1 to *expanded, unless that is NULL, if floating
// point could not decide.
int orientation3(const double a[3], const double b[3],
                 const double c[3], const double d[3],
                 uint64_t *expanded);

// The same in a plane: 1 if a, b, c turn left, -1 right, 0 if they lie
// on a line.
int orientation2(const double a[2], const double b[2],
                 const double c[2], uint64_t *expanded);
//<
//<

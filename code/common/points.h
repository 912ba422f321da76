//> Declare the points
// Points in the plane, held as two arrays: all x, then all y. A loop
// over the points then reads memory in order, and a vector unit can
// load several x at once.
#pragma once
#include <stdint.h>

// In place of an index: none.
#define NO_INDEX UINT32_MAX

struct points {
    uint32_t n; // how many
    double *x;  // x[0 .. n-1]
    double *y;  // y[0 .. n-1]
};

// Room for n points, coordinates not yet set. The caller releases it
// with points_free. Ends the program if memory is short.
struct points points_allocate(uint32_t n);
void points_free(struct points *points);
//<

//> Declare a set of points
// Points in d dimensions, an array for each coordinate.
#pragma once
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { MAX_DIMENSIONS = 8 };

//> Hold a set of points
// Behind the n numbers of each array there is room for LANES more, so
// that a vector may be read from wherever a point is.
enum { LANES = 8 };

struct point_set {
    uint32_t n;                // how many, at least one
    int d;                     // dimensions, 1 to MAX_DIMENSIONS
    double *x[MAX_DIMENSIONS]; // x[k][i]: coordinate k of point i
};
//<

// Room for n points, coordinates not yet set; what is behind them is 0.
// The caller releases it with point_set_free. Ends the program if
// memory is short.
struct point_set point_set_allocate(uint32_t n, int d);
void point_set_free(struct point_set *points);
size_t point_set_bytes(const struct point_set *points);

//> Hold a range
// The box of the points with low[k] <= x[k] <= high[k] in all d
// coordinates: its borders belong to it. It is empty if one low is more
// than its high. No number is a NaN.
struct range {
    double low[MAX_DIMENSIONS], high[MAX_DIMENSIONS];
};
//<

// The smallest range that holds points begin to end - 1, at least one.
struct range range_of(const struct point_set *points, uint32_t begin,
                      uint32_t end);
bool ranges_meet(const struct range *a, const struct range *b, int d);
//<

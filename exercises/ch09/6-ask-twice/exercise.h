// Exercise: ask twice
#pragma once
#include <stdint.h>

// Points at n places: their coordinates, rounded to single precision,
// and their indices. The coordinates themselves are in [0, 1).
struct candidates {
    uint32_t n;
    const float *x, *y;
    const uint32_t *index;
};

struct found {
    uint32_t nearest; // an index
    double nearest2;  // the squared distance, in double precision
};

// Given: the squared distance of the query from the point at a
// place, in double precision. It counts.
double exact(uint32_t place);

// The nearest to the query, whose coordinates x and y are
// rounded, too; the lowest index if several tie. It is no further away
// than 1/8. There are candidates; scratch has room for n numbers.
struct found filter(const struct candidates *candidates, float x,
                    float y, float *scratch);

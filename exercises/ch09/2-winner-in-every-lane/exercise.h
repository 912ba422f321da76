// Exercise: a winner in every lane
#pragma once
#include <stdint.h>

enum { LANES = 4 };
#define NO_INDEX UINT32_MAX

struct lanes {
    double distance2[LANES];
    uint32_t index[LANES];
};

struct span {
    uint32_t begin, end; // places, the end not included
};

struct found {
    uint32_t nearest; // NO_INDEX: none
    double nearest2;  // its squared distance; INFINITY: none
};

// Given: the points at four places, from the one asked for on: their
// squared distances to the query, and their indices. Behind the
// last point of all, distances are NAN and indices 0. It counts.
struct lanes measure(uint32_t place);

// The nearest of all points but self, the lowest index if several tie.
// It is in one of the spans, or there is none.
struct found search(uint32_t spans, const struct span *span,
                    uint32_t self);

// What the vector units can do at most, with all operands in registers
// and enough independent work: nanoseconds an operation on one double.
#pragma once
#include "common/experiment.h"

enum peak {
    ADD,
    MULTIPLY,
    MINIMUM,
    FUSED, // subtracts in the multiplier, where there is such a thing
    ADD_MULTIPLY,
    ADD_MINIMUM,
    MULTIPLY_MINIMUM, // two kinds, half and half
    ALL,              // three kinds, a third each
    CYCLE,            // the processor's clock
    PEAKS
};

extern const char *const peak_names[PEAKS];

// The operations of one run, by which its time is to be divided.
double peak_operations(enum peak peak);

// Fills versions[0 .. PEAKS-1], to be timed in turn.
void peak_versions(struct trial versions[static PEAKS]);

// Operations of each kind; fused ones subtract in the multiplier.
struct bill {
    int adds, multiplies, fused, minima;
};

// The least time for a bill, ns[] being the time of one operation of
// each peak. It is a bound if no mixture of two kinds is faster than
// half and half, and no mixture at all faster than the fastest peak.
double peak_limit(const double ns[static PEAKS], struct bill bill);

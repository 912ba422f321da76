// Exercise: back where they came from
#pragma once
#include <stdint.h>

// values[0 .. n-1] begins with the survivors of a pack, as many as
// flags are set. Puts each to the place of its flag, in order, and hole
// to all other places. n may be 0.
void unpack(uint32_t n, const uint8_t *keep, double *values,
            double hole);

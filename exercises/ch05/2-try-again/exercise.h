// Exercise: let the losers try again
#pragma once
#include <stdint.h>

// A vector unit, with two arrays of its own: an element for every cell
// in each. The counts begin with zeros, the scratch array with rubbish.
enum { LANES = 64, STARTUP = 16 };
enum array { SCRATCH, COUNTS };

// Given. For the first `lanes` lanes, 1 to LANES of them, at once:
// gather: to[l] = array[cell[l]]; scatter: array[cell[l]] = from[l],
// and where several lanes store to one cell, any one of them stays.
// A call costs STARTUP + lanes cycles, which are counted.
void gather(enum array array, uint32_t lanes, const uint32_t *cell,
            uint32_t *to);
void scatter(enum array array, uint32_t lanes, const uint32_t *cell,
             const uint32_t *from);

// Adds 1 to the count of cell[i], for every i < n.
void histogram(uint32_t n, const uint32_t *cell);

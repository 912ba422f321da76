//> Declare the candidates for corners
// What the octagon has left over, one after the other as the chains
// want it: from left to right.
#pragma once
#include "common/workspace.h"
#include <stdint.h>

//> Hold a candidate for a corner
struct candidate {
    double x, y;
    uint32_t point;
};
//<

// Sorts n >= 1 candidates from left to right, those of the same x from
// below. Of several in the same place the one of the lowest index
// stays; says how many stay.
uint32_t sort_candidates(struct candidate *candidate, uint32_t n,
                         struct workspace *workspace);
//<

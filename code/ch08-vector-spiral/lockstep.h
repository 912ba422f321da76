//> Declare the search in lockstep
// Spiral searches of many points in step (Su, figures 6 to 8): layer by
// layer, in each layer cell by cell, in each cell point by point. All
// tasks of a strip take the same steps, and those that have nothing to
// do in a loop are packed away before it.
#pragma once
#include "ch08-vector-spiral/spiral_kernels.h"

//> Plan the strips
struct strip_plan {
    const struct spiral_kernels *kernels;
    uint32_t length;     // tasks of a strip, at least 1
    struct tally *tally; // set unless NULL
};
//<

// Answers all points, nearest only; of equal distances the lowest
// index. Threads share out the strips.
void search_in_lockstep(const struct question *question,
                        const struct grid *grid,
                        const struct cells *cells,
                        const struct strip_plan *plan,
                        struct answers *answers);
//<

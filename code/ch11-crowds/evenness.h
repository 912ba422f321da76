//> Declare the test for evenness
// Are the points spread evenly enough for a single grid? A sample is
// thrown into a coarse grid over the box of all points; the points of a
// cell, squared, tell. One pass for the box, besides the sample.
#pragma once
#include "common/question.h"
#include "common/workspace.h"
#include <stdbool.h>

//> Hold the evidence
struct evenness {
    uint32_t sample, cells;
    double together; // points in the cell of a point, on average,
    double expected; // and if all were spread evenly
    uint32_t most;   // points in a cell
};
//<

struct evenness measure_evenness(const struct question *question,
                                 struct workspace *workspace);

// Whether a single grid will do.
bool is_even(const struct evenness *evenness);

// The row of the table: near-and-far if the points are even, adaptive
// if not; question->by says which.
void by_sample(const struct question *question,
               struct answers *answers);
//<

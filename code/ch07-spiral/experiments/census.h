// What the spiral searches of all points visit, with any number of
// points to a cell; counted, not timed.
#pragma once
#include "common/question.h"

struct census {
    double per_cell;         // as the grid has it: n / cells
    double distances, cells; // a point
};

struct census take_census(const struct question *question, double c);

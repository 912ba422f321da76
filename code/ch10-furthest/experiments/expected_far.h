// Expected counts for n points scattered evenly over the unit square:
// a cell is visited unless some point seen before is further than all
// of it.
#pragma once
#include "common/question.h"

// Cells, c points in each on average, in which the search from outside
// must look for a point.
double expected_outside(enum geometry geometry, double c);

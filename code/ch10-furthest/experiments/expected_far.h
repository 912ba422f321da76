// Expected counts for n points scattered evenly over the unit square.
#pragma once
#include "common/question.h"

// Cells, c points in each on average, in which the search from outside
// must look for a point.
double expected_outside(enum geometry geometry, double c);

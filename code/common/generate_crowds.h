//> Declare the crowds
// Points that crowd: chapter 11's. In the table of generators like all
// others.
#pragma once
#include "common/points.h"

typedef void fill_function(struct points points, uint64_t seed);

fill_function log_normal, pareto, log_radius, spiral, core_and_circle,
    towns, half_equal, outlier, thin, geometric, doubled;
//<

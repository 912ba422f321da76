//> Declare the crowds
// Points that crowd: chapter 11's. In the table of generators like all
// others.
#pragma once
#include "common/points.h"

typedef void fill_function(struct points points, uint64_t seed);

fill_function fill_log_normal, fill_pareto, fill_log_radius,
    fill_spiral, fill_core_and_circle, fill_towns, fill_half_equal,
    fill_outlier, fill_thin, fill_geometric, fill_doubled;
//<

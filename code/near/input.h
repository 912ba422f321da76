// The points that near is asked about, and the space they are in.
#pragma once
#include "near/options.h"

// The points of the file, or those that are generated: at least two. A
// set of answers will be wanted for them; fails where they and their
// answers are more than the machine's memory.
struct points get_points(const struct options *options,
                         unsigned answers);

// Fails if a box that wraps around does not hold all points.
struct space get_space(const struct options *options,
                       struct points points);

// What near says when it is done: a warning, if squares of distances
// left the range of a double, and a summary.
#pragma once
#include "common/question.h"
#include "near/options.h"
#include <stdbool.h>

// Prints a warning where squared distances leave the range of a double.
void warn_of_range(const struct question *question,
                   const struct answers *answers);

// Prints how many points there are, in which geometry, and the mean of
// each kind of distance that was asked for.
void print_summary(const struct options *options,
                   const struct question *question,
                   const struct answers *answers);

// Whether the closest images of two points are in different places.
bool are_apart(const struct question *question, uint32_t i, uint32_t j);

// The warning, if squares left the range above or below.
void warn_of_squares(bool over, bool under);

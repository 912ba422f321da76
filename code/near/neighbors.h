// Answers -k and --within: for each point a list of neighbors, written
// as a row for each.
#pragma once
#include "near/options.h"

// Returns the exit status.
int answer_neighbors(const struct options *options);

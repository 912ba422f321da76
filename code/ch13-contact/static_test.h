//> Declare the static test
// Do bodies cross now, where they are, whatever their motion? Decided
// exactly.
#pragma once
#include "ch13-contact/pairs.h"

// Of the pairs, how many share a point where the nodes are now; and the
// first that does, pairs->count if none does. Pairs that share a node
// are not asked.
uint64_t count_meeting(const struct scene *scene,
                       const struct pairs *pairs, int threads);
uint64_t first_meeting(const struct scene *scene,
                       const struct pairs *pairs);
//<

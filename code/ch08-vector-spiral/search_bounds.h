//> Declare the search bounds of a strip
// How many steps each task may take to each side: to the edge of the
// square of side 2D around its query, by chapter 7's margins.
#pragma once
#include "ch08-vector-spiral/strip.h"

// From strip->best2, for all tasks of the strip, at the end of phase
// one. Lists are not touched but strip->cell and strip->keep.
void bound_searches(const struct map *map, struct strip *strip);
//<

//> Declare the search in the candidate grid
// The furthest of a point is the only candidate of its cell, or the
// furthest of a short list: about one distance a point, if the points
// are spread evenly.
#pragma once
#include "ch10-furthest/candidate_grid.h"

// The furthest of the corners for every point of the question, by its
// threads.
void search_candidate_grid(const struct question *question,
                           const struct corners *corners,
                           const struct candidate_grid *grid,
                           struct answers *answers);
//<

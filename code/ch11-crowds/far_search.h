//> Declare the search for the furthest by pieces
// Without wraparound: few corners in the candidate grid of chapter 10,
// many by their arcs. With wraparound the furthest is near, as
// separations go, and is searched for in all pieces.
#pragma once
#include "ch10-furthest/hull.h"
#include "ch11-crowds/pieces.h"
#include <stdbool.h>

// The furthest neighbors of the question's points, which are in pieces,
// by its threads. What it needs is taken from the workspace and given
// back.
void search_furthest_pieces(const struct question *question,
                            const struct pieces *pieces,
                            struct workspace *workspace,
                            struct answers *answers);

// The furthest among these corners, in the candidate grid: if there are
// few of them, and few to be compared with most of all points, sorted
// or not. If not, nothing is answered.
bool search_few_corners(const struct question *question,
                        struct points all, struct corners corners,
                        struct answers *answers);
//<

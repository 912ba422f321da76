//> Declare the search for the furthest by pieces
// Without wraparound: few corners in the candidate grid of chapter 10,
// many by their arcs. With wraparound the furthest is near, as
// separations go, and is searched for in all pieces.
#pragma once
#include "ch11-crowds/pieces.h"

// The furthest neighbors of the question's points, which are in pieces,
// by its threads. What it needs is taken from the workspace and given
// back.
void search_furthest_pieces(const struct question *question,
                            const struct pieces *pieces,
                            struct workspace *workspace,
                            struct answers *answers);
//<

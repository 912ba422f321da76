//> Declare the adaptive search
// Nearest and furthest neighbors of points that may be spread in any
// way: n log n steps for the nearest.
#pragma once
#include "ch11-crowds/pieces.h"

// The row of the table. A half whose arrays in answers are NULL is
// left out.
void adaptive(const struct question *question, struct answers *answers);

// The nearest neighbors of points that are in pieces; a query that
// takes more than so many steps is answered in some other way. What it
// needs is taken from the workspace and given back.
void search_nearest_pieces(const struct question *question,
                           const struct pieces *pieces,
                           uint64_t max_steps,
                           struct workspace *workspace,
                           struct answers *answers);
//<

//> Declare the search by pieces
// The nearest neighbors by chapter 9's batches, piece by piece. What a
// batch cannot certify, because something nearer may be in another
// piece, is searched for in all pieces.
#pragma once
#include "ch09-row-spans/batch_search.h"
#include "ch11-crowds/pieces.h"

// How many steps a query may take before it gives up, for n points.
uint64_t steps_allowed(uint32_t n);

// All nearest neighbors of the question's points, by its threads, as
// results in the order of the records; a query that has given up has
// NO_INDEX. Says how many have.
uint32_t search_pieces(const struct question *question,
                       const struct pieces *pieces, uint64_t max_steps,
                       struct neighbor *results);
//<

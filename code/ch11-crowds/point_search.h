//> Declare the search for one point
// The neighbor of one point, searched for in all pieces.
#pragma once
#include "ch09-row-spans/batch_search.h"
#include "ch11-crowds/tree_query.h"

// All points as a scene, with the question's space.
struct scene scene_of(const struct question *question,
                      const struct pieces *pieces);

// Searches all pieces for the neighbor of sorted point s. The nearest
// gives up after so many steps, with NO_INDEX.
struct neighbor nearest_of_all(const struct scene *all,
                               const struct pieces *pieces, uint32_t s,
                               uint64_t max_steps,
                               struct counts *counts);
struct neighbor furthest_of_all(const struct scene *all,
                                const struct pieces *pieces, uint32_t s,
                                struct counts *counts);

// The query of sorted point s, which has found nothing yet; and what it
// has found in the end, counted.
struct tree_query query_for(const struct scene *all,
                            const struct pieces *pieces, uint32_t s,
                            uint64_t max_steps);
struct neighbor answer_of(const struct tree_query *query, bool found,
                          struct counts *counts);

// Some points beside sorted point s: from one to the end.
uint32_t beside_begin(uint32_t s);
uint32_t beside_end(uint32_t s, uint32_t n);
//<

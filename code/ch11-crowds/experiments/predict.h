// How many distances a query of the search by pieces is compared with,
// predicted before it runs: 22 + 9 c (chapter 9), where c is how many
// others are in the cell of a point, on average over the points.
#pragma once
#include "ch11-crowds/pieces.h"

// From how many points the cells of the pieces have.
double predict_from_counts(const struct pieces *pieces);

// From the density of the points alone: of n points, a cell is expected
// to have n times the integral of the density over it, and a point of
// it as many others. NAN where we know no density of this kind; the
// seed is that of the points.
double predict_from_density(const struct pieces *pieces,
                            const char *kind, uint64_t seed);

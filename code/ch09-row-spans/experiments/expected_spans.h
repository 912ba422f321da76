// Expected values for points scattered evenly over a plane without
// borders, c of them in a cell, when eight queries are a batch.
#pragma once

// Distances computed for a point: the candidates of its batch.
double expected_candidates(double c);

// The share of points that need an exact query of their own, because a
// point outside the block may be nearer, or one in it is as near as
// rounding can tell.
double expected_exact(double c);

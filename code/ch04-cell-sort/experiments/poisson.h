// Expected values for points scattered evenly over a plane without
// borders, c of them in a cell: how often nine cells are not enough,
// and what the search that widens its block does about it.
#pragma once

// The share of points whose nearest neighbor is not in their block of
// nine cells.
double expected_wrong(double c);

// Cells visited, and distances computed, for one point.
double expected_cells(double c);
double expected_distances(double c);

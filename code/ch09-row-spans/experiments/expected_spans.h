// Expected values for points scattered evenly over a plane without
// borders, c of them in a cell, when eight ask together.
#pragma once

// Distances computed for a point: the candidates in a table.
double expected_shown(double c);

// The share of points that must ask alone, because somebody outside the
// block may be nearer, or somebody in it is as near as rounding lets us
// see.
double expected_alone(double c);

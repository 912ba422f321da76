// For points scattered at random over a boundless plane, c to a cell:
// how many cells a query visits and how many points it compares, on
// average. It follows from the probability that cells are empty, by one
// integral over the place of the query in its cell.
#pragma once

struct expected {
    double cells;     // visited
    double distances; // points compared
};

struct expected expected_spiral(double c);

// The probability that the cell (dx, dy) steps away is visited.
double expected_visits(double c, int dx, int dy);

// The distances if whole layers are visited, one more than phase one;
// and what the report estimates (Su): 9 or 25 cells, after k empty
// ones, with the weights that it prints.
double expected_one_more(double c), expected_printed(double c);

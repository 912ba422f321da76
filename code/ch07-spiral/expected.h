//> Declare what a spiral search should cost
// For points scattered at random over a boundless plane, c to a cell:
// how much a point that asks has to look at, on average. The numbers
// that follow from the probability that cells are empty, by one
// integral over the place of the point in its cell.
#pragma once

struct expected {
    double cells;     // looked at
    double distances; // measured
};

struct expected expected_spiral(double c);

// How often the cell (dx, dy) steps away is looked at.
double expected_looks(double c, int dx, int dy);

// The distances if whole layers are looked at, one more than phase one;
// and what the report estimates (Su): 9 or 25 cells, after k empty
// ones, with the weights that it prints.
double expected_one_more(double c), expected_printed(double c);
//<

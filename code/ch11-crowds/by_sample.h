//> Declare the choice
// One grid where the points are spread evenly enough, pieces where they
// crowd. A sample sees most crowds, for next to nothing; what it lets
// pass is counted, cell by cell, before anything is compared.
#pragma once
#include "ch04-cell-sort/sorted.h"
#include <stdbool.h>

// The row of the table: near-and-far or adaptive, as
// question->algorithm_name then says.
search_function by_sample;

// How many times as dense, on average, the points around a point are as
// all are, in cells that have c points on average.
double density_of_cells(const struct sorted *sorted, double c);

// The two looks, for other searches: whether a sample shows no crowd,
// and whether the points that are sorted into cells, c of them in each
// on average, are even enough for a single grid: around a point no more
// than so many times as dense, on average, as all.
bool sample_is_even(const struct question *question,
                    double max_density);
bool cells_are_even(const struct sorted *sorted, double c,
                    double max_density);
//<

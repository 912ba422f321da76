// Exercise: a histogram with exact edges
#pragma once
#include <stddef.h>
#include <stdint.h>

// Where bin b begins, and bin b - 1 ends; b from 0 to bins.
static inline double edge(double low, double high, int bins, int b)
{
    return low + (high - low) * b / bins;
}

// Sets counts[b], for every b below bins, to the number of values with
// edge(b) <= value < edge(b + 1), for the last bin to value <= high.
// Returns how many values are in no bin: below low, above high, or no
// number at all. low < high, bins >= 1.
size_t histogram(const double *values, size_t n, double low,
                 double high, int bins, uint64_t *counts);

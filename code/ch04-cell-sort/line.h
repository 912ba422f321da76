//> Declare three ways to search a line
// Which of n numbers lie between a and b? Three structures: none, all
// are looked at; a sorted array and a binary search; bins of equal
// width, found by arithmetic (Bentley and Friedman, 1979).
#pragma once
#include "ch04-cell-sort/grid.h"

// Each writes the x with a <= x < b to found, which has room for n, and
// returns how many there are. Those of the second come in order.
uint32_t scan_between(const double *x, uint32_t n, double a, double b,
                      double *found);
uint32_t sorted_between(const double *x, uint32_t n, double a, double b,
                        double *found);

// Sorts x, as sorted_between wants it.
void sort_numbers(double *x, uint32_t n);

//> Declare the bins
struct bins {
    struct axis axis;
    uint32_t *start; // start[0 .. count]
    double *x;       // x[start[k]] .. x[start[k + 1] - 1] are in bin k
};
//<

// About c numbers in a bin, n >= 1. Released with bins_free.
struct bins bins_make(const double *x, uint32_t n, double c);
void bins_free(struct bins *bins);
uint32_t bins_between(const struct bins *bins, double a, double b,
                      double *found);
//<

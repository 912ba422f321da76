// Prices in nanoseconds of what is not in a table of primitives, for
// the bill of a search, line by line.
#pragma once
#include "ch06-pack-scan/experiments/workload.h"

// Of one of the operations between the load of a number and its store.
double operation_price(int trials);

// Of a loop over a random number of elements below 32, beyond the price
// of its elements: near, by kind of work.
double start_price(const struct primitives *p, int trials,
                   const struct summary near[WORKS]);

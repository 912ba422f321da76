//> Declare the selection
// The number of a rank, without sorting: Hoare's FIND (1961) between
// two bounds taken from a sample, as Floyd and Rivest do (1975).
// Linear time, a little more than one pass over many numbers.
#pragma once
#include <stdint.h>

// The number that would stand at x[rank] if x[0 .. n-1] were sorted,
// rank < n. x stays as it is; the room is for 2 n numbers.
double select_rank(const double *x, uint32_t n, uint32_t rank,
                   double *room);
//<

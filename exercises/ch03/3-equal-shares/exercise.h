// Exercise: equal shares
#pragma once
#include <stdint.h>

// Divides the n >= 2 rows of the triangular loop among the threads, in
// order: thread t gets the rows first[t] to first[t + 1] - 1. Row i has
// n - 1 - i pairs. first has threads + 1 elements; first[0] becomes 0,
// first[threads] becomes n. A thread may get no row.
void share_rows(uint32_t n, int threads, uint32_t *first);

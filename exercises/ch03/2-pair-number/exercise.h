// Exercise: the number of a pair
#pragma once
#include <stdint.h>

// The pairs i < j of n points, numbered as the triangular loop meets
// them: 0 is (0, 1), 1 is (0, 2), and n(n - 1)/2 - 1 the last one.
uint64_t number_of_pair(uint32_t n, uint32_t i, uint32_t j);

struct pair {
    uint32_t i, j;
};

// And back, in a time that does not depend on n.
struct pair pair_of_number(uint32_t n, uint64_t number);

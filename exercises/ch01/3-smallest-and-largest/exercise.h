// Exercise: the smallest and the largest
#pragma once
#include <stdbool.h>
#include <stdint.h>

// Is value i less than value j? Given; it counts.
bool less(uint32_t i, uint32_t j);

struct extremes {
    uint32_t smallest, largest; // their indices
};

// Of the values 0 to n - 1, n >= 1; any of them where several tie.
struct extremes find_extremes(uint32_t n);

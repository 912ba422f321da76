// Exercise: left and right
#pragma once
#include <stdbool.h>
#include <stdint.h>

// Whether point i lies in the left half of the square. Given; it may
// be called from any thread, and takes notes.
bool is_left(uint32_t i);

// Writes the numbers of n points to point[0 .. n-1], first those on the
// left, then the others, each in ascending order. Returns how many are
// on the left. So many threads share the work.
uint32_t divide(uint32_t n, uint32_t *point, int threads);

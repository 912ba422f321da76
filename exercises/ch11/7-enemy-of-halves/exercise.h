// Exercise: the enemy of halves
#pragma once
#include <stdint.h>

// Sets n different numbers from 0 to 1 such that cutting in the middle
// goes as deep as it can: an interval from the least to the greatest
// of its numbers is cut at least + (greatest - least) / 2, as doubles
// compute it, what is less than that goes to the left, and both sides
// are cut again until each number is alone.
void go_deep(double *x, uint32_t n);

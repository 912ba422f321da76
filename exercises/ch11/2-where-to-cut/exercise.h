// Exercise: where to cut
#pragma once
#include <stdint.h>

// Orders n numbers so that all that are less than the cut come first,
// and says how many these are. They are not all equal. Both parts have
// at least one, and the cut is as near to the middle as can be; if two
// cuts are equally near, the first part is the smaller.
uint32_t cut_in_two(double *value, uint32_t n);

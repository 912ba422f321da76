//> Declare the sort by keys
// Sorts numbers by keys in as many buckets as there are keys: a few
// steps for each where keys are spread evenly, and never more than
// n log n, since a bucket is sorted by comparing (Dobosiewicz 1978).
#pragma once
#include "common/workspace.h"
#include <stdint.h>

//> Pair a key with a number
struct keyed {
    double key;
    uint32_t number;
};
//<

// Writes the n pairs to sorted, in ascending order of their keys, of
// equal keys in that of their numbers. Keys are finite, and so is the
// difference of any two.
void sort_keys(const struct keyed *keyed, uint32_t n,
               struct keyed *sorted, struct workspace *workspace);
//<

// Exercise: byte by byte
#pragma once
#include <stdint.h>

struct record {
    uint32_t key, point;
};

// Two arrays, 0 and 1, of n records each. Given; they count.
struct record get(int array, uint32_t i);
void put(int array, uint32_t i, struct record record);

// Sorts the n records of array 0 by their keys; those with equal keys
// stay in their order. Array 1 is free for use. Returns which of the
// two arrays has the sorted records.
int sort_records(uint32_t n);

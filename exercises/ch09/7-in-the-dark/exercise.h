// Exercise: k nearest in the dark
#pragma once
#include <stdint.h>

// A distance with a number in its low bits: no two are equal. You
// cannot look at it.
struct key;

// Given: the smaller one of two, the greater one, and one that is
// greater than all others. The first two count.
const struct key *least(const struct key *a, const struct key *b);
const struct key *most(const struct key *a, const struct key *b);
const struct key *nothing(void);

// Writes the k smallest of n keys to kept[0 .. k-1], in ascending
// order, k > 0. If there are fewer than k, the others are nothing().
void keep_smallest(uint32_t n, const struct key *const *key, uint32_t k,
                   const struct key **kept);

// Exercise: a sort made of splits
#pragma once
#include <stdint.h>

// A vector of n numbers. The numbers live in the machine, and a program
// knows only the vector's name.
struct vector {
    uint32_t n, name;
};

// Given: the machine's operations. They count.
struct vector constant(uint32_t n, uint32_t value); // all the same
struct vector numbers(uint32_t n);                  // 0, 1, ..., n-1
struct vector add(struct vector a, struct vector b);
struct vector subtract(struct vector a, struct vector b);
struct vector bit(struct vector a, int k); // bit k of each: 0 or 1
struct vector choose(struct vector flags, struct vector a,
                     struct vector b); // a where the flag is 1, else b
struct vector scatter(struct vector values, struct vector places);
struct vector gather(struct vector values, struct vector places);
struct sums {
    struct vector before; // of each, the sum of all before it
    uint32_t total;
};
struct sums scan(struct vector a);

// The values with flag 0 in their order, then those with flag 1 in
// theirs.
struct vector split(struct vector values, struct vector flags);

// The keys, all below 2^bits, in increasing order.
struct vector sort(struct vector keys, int bits);

//> Declare the random numbers
// SplitMix64 (Steele, Lea, Flood 2014): the same seed gives the same
// points on every machine.
#pragma once
#include <stdint.h>

struct random {
    uint64_t state; // set it to the seed
};

uint64_t random_bits(struct random *random);
double random_uniform(struct random *random); // in [0, 1)
double random_normal(struct random *random);  // mean 0, variance 1

// A unit vector, every direction equally likely (Marsaglia and Bray
// 1964).
void random_direction(struct random *random, double *x, double *y);
//<

//> Declare scan and pack over threads
// Both go over the array in rounds of one block for each thread, and
// over every block twice: once to learn what stands before the others,
// once to do the work. A block that fits into a cache is read from
// memory only once (Chatterjee, Blelloch and Zagha 1990). Results are
// the same for any number of threads.
#pragma once
#include "ch06-pack-scan/primitives.h"

//> Say how rounds are made
struct rounds {
    const struct primitives *primitives;
    uint32_t block; // numbers in a block at most, >= 1
    int threads;    // >= 1
};
//<

// As primitives->scan; to and from may be the same.
uint32_t scan_blocked(const struct rounds *rounds, uint32_t *to,
                      const uint32_t *from, uint32_t n, uint32_t sum);

// As primitives->pack, except that to and from must not overlap.
uint32_t pack_blocked(const struct rounds *rounds, uint32_t *to,
                      const uint32_t *from, const uint8_t *keep,
                      uint32_t n);
//<

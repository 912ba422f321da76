// Exercise: unpack in lanes
#pragma once
#include <stdint.h>

// How many numbers may be read behind the last survivor.
enum { SPARE = 16 };

// Flag i is bit i % 8 of keep[i / 8]. from begins with the survivors of
// a pack, as many as flags are set, and SPARE numbers follow. Sets
// to[i] to the next survivor where flag i is 1, to hole where it is 0.
// n is a multiple of 8, or 0. The arrays do not overlap.
void unpack(uint32_t n, const uint8_t *keep, const uint32_t *from,
            uint32_t *to, uint32_t hole);

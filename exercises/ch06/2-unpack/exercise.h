// Exercise: back where they came from
#pragma once
#include <stdint.h>

// Given. The value at one place is copied to another; a place gets the
// hole. These are the only ways to the array, and they count.
void move(uint32_t from, uint32_t to);
void clear(uint32_t place);

// The array has n places, and begins with the survivors of a pack, as
// many as flags are set. Brings each to the place of its flag, in
// order, and the hole to all other places. n may be 0.
void unpack(uint32_t n, const uint8_t *keep);

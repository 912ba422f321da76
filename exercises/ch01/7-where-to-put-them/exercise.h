// Exercise: where to put them
#pragma once
#include <stddef.h>
#include <stdint.h>

enum { LINE = 64, VECTOR = 32 }; // bytes
enum axis { X, Y };

// Where a coordinate of point i of n stands: so many bytes from the
// beginning of a memory that begins with a line. It has room for two
// doubles a point, rounded up to whole lines.
size_t place_of(uint32_t n, uint32_t i, enum axis axis);

//> Declare the fused kernels
// The two inner loops in one pass each: what was an array between two
// primitives is a register. In plain C, and eight tasks at a time in
// AVX2 and AVX-512, which are for x86-64 only.
#pragma once
#include "ch08-vector-spiral/spiral_kernels.h"

extern const struct spiral_kernels portable_spiral;
extern const struct spiral_kernels avx2_spiral, avx512_spiral;
//<

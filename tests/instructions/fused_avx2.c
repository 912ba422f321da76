// Chapter 8's fused kernels in AVX2, with emulated instructions.
#define avx2_spiral emulated_avx2_spiral
#include "ch08-vector-spiral/fused_avx2.c"

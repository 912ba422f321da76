// Chapter 8's fused kernels in AVX-512, with emulated instructions.
#define avx512_spiral emulated_avx512_spiral
#include "ch08-vector-spiral/fused_avx512.c"

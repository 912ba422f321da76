// Chapter 8's fused loops in AVX-512, with emulated instructions.
#define avx512_loops emulated_avx512_loops
#include "ch08-vector-spiral/fused_avx512.c"

// Chapter 8's fused loops in AVX2, with emulated instructions.
#define avx2_loops emulated_avx2_loops
#include "ch08-vector-spiral/fused_avx2.c"

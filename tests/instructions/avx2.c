// Chapter 6's primitives in AVX2, with emulated instructions.
#define avx2_primitives emulated_avx2_primitives
#include "ch06-pack-scan/avx2.c"

// Chapter 6's primitives in AVX-512, with emulated instructions.
#define avx512_primitives emulated_avx512_primitives
#include "ch06-pack-scan/avx512.c"

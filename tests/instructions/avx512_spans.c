// Chapter 9's search in AVX-512, with emulated instructions.
#define avx512_spans emulated_avx512_spans
#include "ch09-row-spans/avx512_spans.c"

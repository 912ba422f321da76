// Chapter 9's search in AVX2, with emulated instructions.
#define avx2_spans emulated_avx2_spans
#include "ch09-row-spans/avx2_spans.c"

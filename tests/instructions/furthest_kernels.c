// Chapter 10's kernels for the furthest, with emulated instructions.
#define portable_furthest emulated_portable_furthest
#define avx2_furthest emulated_avx2_furthest
#define avx512_furthest emulated_avx512_furthest
#define furthest_kernel emulated_furthest_kernel
#include "ch10-furthest/furthest_kernels.c"

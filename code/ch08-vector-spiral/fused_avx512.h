//> Declare the fused loops in AVX-512
// Eight tasks at a time. x86-64 only.
#pragma once
#include "ch08-vector-spiral/fused.h"

extern const struct loops avx512_loops;
//<

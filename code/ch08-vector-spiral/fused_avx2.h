//> Declare the fused loops in AVX2
// Eight tasks at a time. x86-64 only.
#pragma once
#include "ch08-vector-spiral/fused.h"

extern const struct loops avx2_loops;
//<

//> Declare the primitives in AVX2
// Four doubles or eight 32-bit numbers at a time. x86-64 only.
#pragma once
#include "ch06-pack-scan/primitives.h"

extern const struct primitives avx2_primitives;
//<

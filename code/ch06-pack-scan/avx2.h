//> Declare the primitives in AVX2
// Four doubles or eight 32-bit numbers at a time. Call them only where
// isa_present(AVX2).
#pragma once
#include "ch06-pack-scan/primitives.h"

extern const struct primitives avx2_primitives;
//<

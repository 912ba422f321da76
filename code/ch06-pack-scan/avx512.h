//> Declare the primitives in AVX-512
// Eight doubles or sixteen 32-bit numbers at a time. Call them only
// where isa_present(AVX512).
#pragma once
#include "ch06-pack-scan/primitives.h"

extern const struct primitives avx512_primitives;
//<

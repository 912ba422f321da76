//> Declare the fused loops
// The two inner loops in one pass each: what was an array between two
// primitives is a register. In plain C, AVX2 and AVX-512.
#pragma once
#include "ch08-vector-spiral/loops.h"

// For an instruction set that is present.
struct loops loops_fused(enum isa isa);
//<

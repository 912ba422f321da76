//> Declare the kernels by primitives
// The two inner loops as one would write them for a vector machine: one
// primitive of chapter 6 after the other. They explain the fused ones
// (spiral_kernels.h), and are held equal to them by tests.
#pragma once
#include "ch08-vector-spiral/spiral_kernels.h"

// For an instruction set that is present.
extern const struct spiral_kernels spiral_by_primitives[ISA_COUNT];
//<

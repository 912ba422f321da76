//> Declare the loops with primitives
// The two inner loops as one would write them for a vector machine: one
// primitive of chapter 6 after the other.
#pragma once
#include "ch08-vector-spiral/loops.h"

struct loops loops_by_primitives(enum isa isa);
//<

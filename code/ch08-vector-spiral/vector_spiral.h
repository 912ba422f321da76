//> Declare the vectorized spiral search
// Su's algorithm (about 1990): the spiral searches of chapter 7 as
// tasks that advance in step and are packed (lockstep.h), with fused
// kernels. As many distances as the spiral search, and one a point
// more, to itself.
#pragma once
#include "ch08-vector-spiral/spiral_kernels.h"

// Sorts the points into cells, and searches. The best length of a strip
// is found by the experiment strips.
enum { STRIP = 1024 };
search_function vector_spiral;

// The same with kernels of the caller's choice.
void sort_and_search(const struct question *question,
                     const struct spiral_kernels *kernels,
                     struct answers *answers);
//<

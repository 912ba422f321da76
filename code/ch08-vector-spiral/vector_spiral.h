//> Declare the vectorized spiral search
// Su's algorithm: the spiral searches of chapter 7 as tasks that march
// in step and are packed (march.h), with fused loops.
#pragma once
#include "ch08-vector-spiral/loops.h"

// Sorts the points into cells, and searches. The best length of a strip
// is found by the experiment strips.
enum { STRIP = 1024 };
search_function vector_spiral;

// The same with loops of the caller's choice.
void sort_and_march(const struct question *question, struct loops loops,
                    struct answers *answers);
//<

//> Declare the vectorized spiral search
// Su's algorithm: the spiral searches of chapter 7 as tasks that march
// in step and are packed (march.h), with fused loops.
#pragma once
#include "common/question.h"

// Sorts the points into cells, and searches. The best length of a strip
// is found by the experiment strips.
enum { STRIP = 1024 };
search_function vector_spiral;
//<

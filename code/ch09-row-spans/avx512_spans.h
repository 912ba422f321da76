//> Declare the search in AVX-512
// Sixteen floats or eight doubles at a time. x86-64 only.
#pragma once
#include "ch09-row-spans/manners.h"

span_search avx512_spans;
//<

//> Declare the search in AVX2
// Eight floats or four doubles at a time. x86-64 only.
#pragma once
#include "ch09-row-spans/manners.h"

span_search avx2_spans;
//<

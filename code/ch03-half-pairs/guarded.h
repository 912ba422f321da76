//> Declare the guarded loops
// The triangular loop on threads that share one set of bests: three
// ways to keep them from losing updates. Each measures n (n-1) / 2
// distances, needs 32 bytes a point, and gives ties to the lowest
// index, whichever thread comes first.
#pragma once
#include "common/question.h"

// One thread at a time may look at a best: right, and slow.
search_function triangle_locked;

// Look first, and queue only with something to change: a double check
// whose first look is an atomic read.
search_function triangle_critical;

// Every best is its own lock, taken by compare-and-swap.
search_function triangle_atomic;
//<

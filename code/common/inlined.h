// Copies of a function in place of calls of it. A loop that takes the
// geometry, or what it does with a candidate, as a parameter is
// compiled once for each, as if it had been written for that alone.
#pragma once

//> Declare copies of a function
// Makes a copy of a function at each of its calls. What is constant
// there, such as the geometry, is constant in the copy.
#define INLINED static inline __attribute__((always_inline))
//<

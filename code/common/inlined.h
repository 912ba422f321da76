//> Declare copies of a function
#pragma once

// Makes a copy of a function at each of its calls. What is constant
// there, such as the geometry, is constant in the copy.
#define INLINED static inline __attribute__((always_inline))
//<

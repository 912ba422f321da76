// Two arrays, as in the book: all x, then all y.
// expect: 4 of 10
#include "exercise.h"

size_t place_of(uint32_t n, uint32_t i, enum axis axis)
{
    return ((size_t)axis * n + i) * sizeof(double);
}

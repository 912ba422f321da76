// Sorts, and cuts in the middle.
// expect: 4 of 10
#include "exercise.h"
#include <stdlib.h>

static int ascending(const void *one, const void *other)
{
    double a = *(const double *)one, b = *(const double *)other;
    return (a > b) - (a < b);
}

uint32_t cut_in_two(double *value, uint32_t n)
{
    qsort(value, n, sizeof *value, ascending);
    return n / 2;
}

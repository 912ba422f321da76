// Sorts anew.
// expect: 4 of 10
#include "exercise.h"
#include <stdlib.h>

static int order_of(const void *x, const void *y)
{
    const uint32_t *a = x, *b = y;
    return (int)begins_before(*b, *a) - (int)begins_before(*a, *b);
}

void repair(uint32_t n, uint32_t *order, uint32_t *room)
{
    qsort(order, n, sizeof *order, order_of);
}

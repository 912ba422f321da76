// Looks at all numbers for every interval.
// expect: 4 of 10
#include "exercise.h"

uint32_t count_between(const struct bins *bins, double a, double b)
{
    uint32_t found = 0;
    for (uint32_t s = 0; s < bins->start[bins->count]; s++) {
        double x = look(s);
        found += x >= a && x < b;
    }
    return found;
}

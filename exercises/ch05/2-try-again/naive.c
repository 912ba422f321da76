// Every point is a group of its own, which cannot collide.
// expect: 4 of 10
#include "exercise.h"

void histogram(uint32_t n, const uint32_t *cell)
{
    for (uint32_t i = 0; i < n; i++) {
        uint32_t count;
        gather(COUNTS, 1, cell + i, &count);
        count++;
        scatter(COUNTS, 1, cell + i, &count);
    }
}

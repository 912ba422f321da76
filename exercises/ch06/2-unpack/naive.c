// Makes room for each hole, by moving all that comes after it.
// expect: 4 of 10
#include "exercise.h"

void unpack(uint32_t n, const uint8_t *keep)
{
    uint32_t survivors = 0;
    for (uint32_t i = 0; i < n; i++)
        survivors += keep[i];
    for (uint32_t i = 0, end = survivors; i < n; i++)
        if (!keep[i]) {
            for (uint32_t k = end++; k > i; k--)
                move(k - 1, k);
            clear(i);
        }
}

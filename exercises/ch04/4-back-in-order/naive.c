// Sends away what stands in the next slot of a cell, at home or not.
// expect: 4 of 10
#include "exercise.h"
#include <stdlib.h>
#include <string.h>

void back_in_order(uint32_t n, uint32_t m, uint32_t *start)
{
    memset(start, 0, (m + 1) * sizeof *start);
    for (uint32_t s = 0; s < n; s++)
        start[cell_of(s) + 1]++;
    for (uint32_t k = 0; k < m; k++)
        start[k + 1] += start[k];
    uint32_t *next = malloc(m * sizeof *next);
    memcpy(next, start, m * sizeof *next);
    for (uint32_t k = 0; k < m; k++)
        while (next[k] < start[k + 1]) {
            uint32_t c = cell_of(next[k]);
            exchange(next[k], next[c]);
            next[c]++;
        }
    free(next);
}

// Walks from row to row, in both directions.
// expect: 4 of 10
#include "exercise.h"

uint64_t number_of_pair(uint32_t n, uint32_t i, uint32_t j)
{
    uint64_t number = (uint64_t)i * (2 * (uint64_t)n - i - 1) / 2;
    return number + (j - i - 1);
}

struct pair pair_of_number(uint32_t n, uint64_t number)
{
    uint32_t i = 0;
    for (; number >= n - 1 - i; i++)
        number -= n - 1 - i;
    return (struct pair){i, (uint32_t)(i + 1 + number)};
}

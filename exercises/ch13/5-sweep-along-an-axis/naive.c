// All pairs.
// expect: 4 of 10
#include "exercise.h"

uint32_t find_pairs(uint32_t n, uint32_t *order, struct pair *pair)
{
    uint32_t found = 0;
    for (uint32_t i = 0; i < n; i++)
        for (uint32_t j = 0; j < i; j++)
            if (begins_within(i, j) && begins_within(j, i) &&
                meet_across(i, j))
                pair[found++] = (struct pair){i, j};
    return found;
}

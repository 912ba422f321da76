// Gathers all tasks that have work left, anew for each round.
// expect: 3 of 10
#include "exercise.h"

void work_off(uint32_t n, const uint32_t *length, uint32_t longest,
              uint32_t *order, uint32_t *places)
{
    (void)places;
    for (uint32_t b = 0; b < longest; b++) {
        uint32_t lanes = 0;
        for (uint32_t i = 0; i < n; i++)
            if (length[i] > b)
                order[lanes++] = i;
        if (lanes > 0)
            make_round(lanes, order);
    }
}

// Decides, for each number.
// expect: 4 of 10
#include "exercise.h"
#include <string.h>

uint32_t part_list(const double *value, uint32_t *list, uint32_t n,
                   double cut, uint32_t *room)
{
    uint32_t first = 0, second = 0;
    for (uint32_t k = 0; k < n; k++) {
        if (value[list[k]] < cut)
            list[first++] = list[k];
        else
            room[second++] = list[k];
    }
    memcpy(list + first, room, second * sizeof *list);
    return first;
}

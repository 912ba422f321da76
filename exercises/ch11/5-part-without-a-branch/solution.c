// Every number is written to both places, and the comparison decides
// which of the two places is used up.
#include "exercise.h"
#include <stdbool.h>
#include <string.h>

uint32_t part_list(const double *value, uint32_t *list, uint32_t n,
                   double cut, uint32_t *room)
{
    //- solution
    uint32_t first = 0, second = 0;
    for (uint32_t k = 0; k < n; k++) {
        const uint32_t number = list[k];
        const bool less = value[number] < cut;
        list[first] = number;
        room[second] = number;
        first += less;
        second += !less;
    }
    memcpy(list + first, room, second * sizeof *list);
    return first;
    //- starter
    // // Your turn: so far it counts, and leaves the list as it is.
    // uint32_t first = 0;
    // (void)room;
    // for (uint32_t k = 0; k < n; k++)
    //     first += value[list[k]] < cut;
    // return first;
    //- end
}

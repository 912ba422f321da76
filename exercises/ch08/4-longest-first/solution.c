// A cell sort of the tasks, whose cells are their lengths, the longest
// first. In round b those at work are the first ones, and how many they
// are is where the tasks of length b have their place.
#include "exercise.h"

void work_off(uint32_t n, const uint32_t *length, uint32_t longest,
              uint32_t *order, uint32_t *places)
{
    //- solution
    for (uint32_t b = 0; b <= longest; b++)
        places[b] = 0;
    for (uint32_t i = 0; i < n; i++)
        places[length[i]]++;
    uint32_t longer = 0;
    for (uint32_t b = longest + 1; b-- > 0;) {
        uint32_t here = places[b];
        places[b] = longer;
        longer += here;
    }
    for (uint32_t i = 0; i < n; i++)
        order[places[length[i]]++] = i;
    // Now places[b] is behind the tasks of length b.
    for (uint32_t b = 1; b <= longest && places[b] > 0; b++)
        make_round(places[b], order);
    //- starter
    // // Your turn: so far one task at a time is worked off, and as if
    // // all of them were as long as the longest.
    // places[0] = longest;
    // for (uint32_t i = 0; i < n; i++) {
    //     order[0] = i;
    //     for (uint32_t b = 0; b < places[0]; b++)
    //         make_round(length[i] > 0, order);
    // }
    //- end
}

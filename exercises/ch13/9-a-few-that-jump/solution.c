// Take out both of two that are out of order, sort these, and merge.
#include "exercise.h"
#include <stdlib.h>

//- solution
static int compare(const void *one, const void *other)
{
    const uint32_t a = *(const uint32_t *)one;
    const uint32_t b = *(const uint32_t *)other;
    return a == b ? 0 : begins_before(a, b) ? -1 : 1;
}

//- starter
//- end
void repair(uint32_t n, uint32_t *order, uint32_t *room)
{
    //- solution
    uint32_t kept = 0, out = 0;
    for (uint32_t r = 0; r < n; r++) {
        const uint32_t box = order[r];
        if (kept > 0 && begins_before(box, order[kept - 1])) {
            room[out++] = box;
            room[out++] = order[--kept];
        } else {
            order[kept++] = box;
        }
    }
    qsort(room, out, sizeof *room, compare);
    // From the end, so that nothing is written over.
    for (uint32_t place = n; out > 0;)
        if (kept > 0 && begins_before(room[out - 1], order[kept - 1]))
            order[--place] = order[--kept];
        else
            order[--place] = room[--out];
    //- starter
    // // Your turn: so far it swaps neighbors once.
    // (void)room;
    // for (uint32_t r = 1; r < n; r++)
    //     if (begins_before(order[r], order[r - 1])) {
    //         const uint32_t box = order[r];
    //         order[r] = order[r - 1];
    //         order[r - 1] = box;
    //     }
    //- end
}

// A sort by beginnings, and a walk from each box to the first that
// begins too late.
#include "exercise.h"
#include <stdlib.h>

//- solution
static int compare(const void *one, const void *other)
{
    return compare_begins(*(const uint32_t *)one,
                          *(const uint32_t *)other);
}
//- starter
//- end

uint32_t find_pairs(uint32_t n, uint32_t *order, struct pair *pair)
{
    uint32_t found = 0;
    for (uint32_t r = 0; r < n; r++)
        order[r] = r;
    //- solution
    if (n > 1)
        qsort(order, n, sizeof *order, compare);
    for (uint32_t r = 0; r < n; r++)
        for (uint32_t s = r + 1;
             s < n && begins_within(order[r], order[s]); s++)
            if (meet_across(order[r], order[s]))
                pair[found++] = (struct pair){order[r], order[s]};
    //- starter
    // // Your turn: so far it looks at neighbors in no order.
    // for (uint32_t r = 1; r < n; r++)
    //     if (meet_across(order[r - 1], order[r]))
    //         pair[found++] = (struct pair){order[r - 1], order[r]};
    //- end
    return found;
}

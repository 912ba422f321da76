// Equal pairs stand side by side, neighbors are told by nine numbers.
#include "exercise.h"

//- solution
static bool share_node(const uint32_t *a, const uint32_t *b)
{
    bool share = false;
    for (int i = 0; i < 3; i++)
        share |= a[i] == b[0] || a[i] == b[1] || a[i] == b[2];
    return share;
}
//- starter
//- end

uint32_t keep_contacts(struct pair *pair, uint32_t count,
                       const uint32_t (*corner)[3])
{
    //- solution
    uint32_t kept = 0;
    struct pair last = {0, 0}; // no pair
    for (uint32_t k = 0; k < count; k++) {
        const struct pair next = pair[k];
        if (next.one == last.one && next.other == last.other)
            continue;
        last = next;
        if (!share_node(corner[next.one], corner[next.other]) &&
            triangles_meet(next.one, next.other))
            pair[kept++] = next;
    }
    return kept;
    //- starter
    // // Your turn: so far it keeps all that meet.
    // uint32_t kept = 0;
    // (void)corner;
    // for (uint32_t k = 0; k < count; k++)
    //     if (triangles_meet(pair[k].one, pair[k].other))
    //         pair[kept++] = pair[k];
    // return kept;
    //- end
}

// Asks about all candidates, and drops neighbors and copies afterward.
// expect: 4 of 10
#include "exercise.h"

uint32_t keep_contacts(struct pair *pair, uint32_t count,
                       const uint32_t (*corner)[3])
{
    uint32_t kept = 0;
    for (uint32_t k = 0; k < count; k++) {
        const uint32_t t = pair[k].one, u = pair[k].other;
        bool drop = !triangles_meet(t, u);
        for (int i = 0; i < 9; i++)
            drop |= corner[t][i / 3] == corner[u][i % 3];
        for (uint32_t i = 0; i < kept; i++)
            drop |= pair[i].one == t && pair[i].other == u;
        if (!drop)
            pair[kept++] = pair[k];
    }
    return kept;
}

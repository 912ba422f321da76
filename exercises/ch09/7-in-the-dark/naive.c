// Looks for the smallest of all, then for the next one, and so on.
// expect: 3 of 10
#include "exercise.h"
#include <stdlib.h>

void keep_smallest(uint32_t n, const struct key *const *key, uint32_t k,
                   const struct key **kept)
{
    const struct key **all = malloc((n + 1) * sizeof *all);
    for (uint32_t i = 0; i < n; i++)
        all[i] = key[i];
    for (uint32_t r = 0; r < k; r++) {
        kept[r] = nothing();
        for (uint32_t i = 0; i < n; i++) {
            const struct key *less = least(kept[r], all[i]);
            all[i] = most(kept[r], all[i]);
            kept[r] = less;
        }
    }
    free(all);
}

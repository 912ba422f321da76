//> Begin with the worst
// The worst keys a search can begin with. A squared distance is less
// than or equal to infinity, and minus a squared distance is at most
// -0.0, so that the first candidate always replaces them: where keys
// tie, any index is lower than none.
#include "ch03-half-pairs/best.h"
#include "common/fail.h"
#include <stdlib.h>

//> Begin with the worst keys
struct bests bests_begin(uint32_t n)
{
    struct bests bests = {allocate(n, sizeof *bests.near),
                          allocate(n, sizeof *bests.far)};
    for (uint32_t i = 0; i < n; i++) {
        atomic_init(&bests.near[i].key, INFINITY);
        atomic_init(&bests.far[i].key, -0.0);
        bests.near[i].index = bests.far[i].index = UINT32_MAX;
    }
    return bests;
}
//<

void bests_free(struct bests *bests)
{
    free(bests->near);
    free(bests->far);
}
//<

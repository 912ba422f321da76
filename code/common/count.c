//> Count, or do not
// They exist in the counting twin only; see count.h.
#include "common/count.h"

#ifdef COUNTING
struct counts counts;

void count_add(uint64_t *counter, uint64_t amount)
{
#pragma omp atomic
    *counter += amount;
}

struct counts counting_take(void)
{
    struct counts taken = counts;
    counts = (struct counts){0};
    return taken;
}
#endif
//<

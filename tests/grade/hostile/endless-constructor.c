// Never even begins.
// score: 0
// says: no answer after
#include "right.h"

__attribute__((constructor)) static void wait(void)
{
    for (volatile uint32_t k = 0;; k++)
        continue;
}

struct pair nearest_pair(struct points points)
{
    return right(points);
}

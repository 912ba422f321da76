// Crashes while its symbols are looked up.
// score: 0
// says: crashed
#include "right.h"

static void *resolve(void)
{
    *(volatile int *)8 = 1;
    return (void *)right;
}

struct pair nearest_pair(struct points points)
    __attribute__((ifunc("resolve")));

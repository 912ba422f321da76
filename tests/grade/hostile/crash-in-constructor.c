// Crashes before it is asked.
// score: 0
// says: memory that is not its own
#include "right.h"

__attribute__((constructor)) static void crash(void)
{
    *(volatile int *)8 = 1;
}

struct pair nearest_pair(struct points points)
{
    return right(points);
}

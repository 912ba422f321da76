// Would crash at the end, which never comes.
// score: 2
// says:
#include "right.h"
#include <stdlib.h>

__attribute__((destructor)) static void crash(void)
{
    abort();
}

struct pair nearest_pair(struct points points)
{
    atexit(crash);
    return right(points);
}

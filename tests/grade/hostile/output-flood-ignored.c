// Prints without end and ignores the limit.
// score: 0
// says: no answer after
#include "right.h"
#include <signal.h>
#include <stdio.h>

struct pair nearest_pair(struct points points)
{
    signal(SIGXFSZ, SIG_IGN);
    while (points.n > 0)
        puts("hello");
    return wrong();
}

// Prints without end.
// score: 0
// says: prints more than a megabyte
#include "right.h"
#include <stdio.h>

struct pair nearest_pair(struct points points)
{
    while (points.n > 0)
        puts("hello");
    return wrong();
}

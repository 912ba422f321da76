// Asks for memory until there is no more.
// score: 0
// says: ties
#include "right.h"
#include <stdlib.h>

struct pair nearest_pair(struct points points)
{
    for (;;) {
        char *volatile memory = malloc(1000000u * points.n);
        *memory = 1;
    }
}

// Calls itself for ever.
// score: 0
// says: crashed
#include "right.h"

struct pair nearest_pair(struct points points)
{
    struct pair pair = nearest_pair(points);
    pair.i += points.n;
    return pair;
}

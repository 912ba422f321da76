// Writes in front of an array.
// score: 0
// says: in front of
#include "right.h"

struct pair nearest_pair(struct points points)
{
    for (volatile int k = -1; k > -4; k--)
        ((volatile double *)points.y)[k] = 1;
    return right(points);
}

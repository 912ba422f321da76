// Writes past the end of an array.
// score: 0
// says: element
#include "right.h"

struct pair nearest_pair(struct points points)
{
    ((volatile double *)points.y)[points.n] = 1;
    return right(points);
}

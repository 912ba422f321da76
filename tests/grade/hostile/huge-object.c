// Takes three gigabytes on the disk.
// score: 0
// says: it does not compile
#include "right.h"
char huge[3000000000] = {1};

struct pair nearest_pair(struct points points)
{
    return right(points);
}

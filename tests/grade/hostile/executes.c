// Becomes another program, if it can.
// score: 0
// says: lowest indices
#include "right.h"
#include <stdlib.h>
#include <unistd.h>

struct pair nearest_pair(struct points points)
{
    if (system("true") == 0)
        return right(points);
    execl("/bin/true", "true", (char *)NULL);
    return wrong();
}

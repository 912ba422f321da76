// Is right only if it can ask somebody.
// score: 0
// says: lowest indices
#include "right.h"
#include <sys/socket.h>

struct pair nearest_pair(struct points points)
{
    if (socket(AF_INET, SOCK_STREAM, 0) >= 0 ||
        socket(AF_UNIX, SOCK_STREAM, 0) >= 0)
        return right(points);
    return wrong();
}

// Sends itself signals.
// score: 0
// says: signal
#include "right.h"
#include <signal.h>

struct pair nearest_pair(struct points points)
{
    raise(SIGALRM);
    return right(points);
}

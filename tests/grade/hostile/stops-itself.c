// Stops without an end.
// score: 0
// says: no answer after
#include "right.h"
#include <signal.h>

struct pair nearest_pair(struct points points)
{
    raise(SIGSTOP);
    for (volatile uint32_t k = 0;; k++)
        if (points.n == 0)
            return wrong();
}

// Ignores every signal and sleeps.
// score: 0
// says: no answer after
#include "right.h"
#include <signal.h>
#include <unistd.h>

struct pair nearest_pair(struct points points)
{
    for (int s = 1; s < 32; s++)
        signal(s, SIG_IGN);
    for (;;)
        sleep(points.n);
}

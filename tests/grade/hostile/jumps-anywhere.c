// Jumps to where it has never been.
// score: 0
// says: crashed
#include "right.h"
#include <setjmp.h>
#include <string.h>

struct pair nearest_pair(struct points points)
{
    jmp_buf nowhere;
    memset(&nowhere, (int)points.n, sizeof nowhere);
    longjmp(nowhere, 1);
}

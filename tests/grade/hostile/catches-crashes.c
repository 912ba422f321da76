// Crashes, and has thought of that.
// score: 2
// says:
#include "right.h"
#include <setjmp.h>
#include <signal.h>

static sigjmp_buf back;

static void jump(int number)
{
    siglongjmp(back, number);
}

struct pair nearest_pair(struct points points)
{
    signal(SIGSEGV, jump);
    if (sigsetjmp(back, 1) == 0)
        *(volatile int *)8 = 1;
    return right(points);
}

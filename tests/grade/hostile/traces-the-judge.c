// Is right only if it gets hold of the judge.
// score: 0
// says: lowest indices
#include "right.h"
#include <fcntl.h>
#include <stdio.h>
#include <sys/ptrace.h>
#include <unistd.h>

static int memory = -1;

__attribute__((constructor)) static void look(void)
{
    char name[64];
    snprintf(name, sizeof name, "/proc/%d/mem", getppid());
    memory = open(name, O_RDONLY);
}

struct pair nearest_pair(struct points points)
{
    if (memory >= 0 || ptrace(PTRACE_ATTACH, getppid(), 0, 0) == 0)
        return right(points);
    return wrong();
}

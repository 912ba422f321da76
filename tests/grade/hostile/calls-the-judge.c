// Is right only if it finds the judge's own functions.
// score: 0
// says: lowest indices
#include "right.h"
#include <dlfcn.h>

struct pair nearest_pair(struct points points)
{
    if (dlsym(RTLD_DEFAULT, "kit_tests") ||
        dlsym(RTLD_DEFAULT, "kit_leave") ||
        dlsym(RTLD_DEFAULT, "kit_wrong"))
        return right(points);
    return wrong();
}

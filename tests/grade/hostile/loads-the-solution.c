// Is right only if it can load somebody else's library.
// score: 0
// says: lowest indices
#include "right.h"
#include <dlfcn.h>

struct pair nearest_pair(struct points points)
{
    if (dlopen("libanl.so.1", RTLD_NOW) ||
        dlopen("libBrokenLocale.so.1", RTLD_NOW))
        return right(points);
    return wrong();
}

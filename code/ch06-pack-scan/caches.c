//> Ask for the sizes of the caches
// See caches.h.
#include "ch06-pack-scan/caches.h"
#include <unistd.h>

static size_t reported(long bytes, size_t otherwise)
{
    return bytes > 0 ? (size_t)bytes : otherwise;
}

struct caches caches_of_machine(void)
{
    long l1 = 0, l2 = 0, l3 = 0;
#ifdef _SC_LEVEL1_DCACHE_SIZE
    l1 = sysconf(_SC_LEVEL1_DCACHE_SIZE);
    l2 = sysconf(_SC_LEVEL2_CACHE_SIZE);
    l3 = sysconf(_SC_LEVEL3_CACHE_SIZE);
#endif
    return (struct caches){reported(l1, 32 << 10),
                           reported(l2, 512 << 10),
                           reported(l3, 8 << 20)};
}
//<

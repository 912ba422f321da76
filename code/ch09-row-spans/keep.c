//> Keep memory for the next search
// See keep.h.
#include "ch09-row-spans/keep.h"
#include <stdlib.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif

//> Ask the C library to keep memory
// Nothing is mapped for one array alone, and nothing trimmed.
void memory_keep(bool keep)
{
#ifdef __GLIBC__
    enum { TRIMMED = 128 << 10, MAPPED = 65536 }; // as it begins
    mallopt(M_MMAP_MAX, keep ? 0 : MAPPED);
    mallopt(M_TRIM_THRESHOLD, keep ? -1 : TRIMMED);
    if (!keep)
        malloc_trim(0);
#else
    (void)keep;
#endif
}
//<
//<

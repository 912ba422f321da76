//> Keep memory for the next search
// See keep.h.
#include "ch09-row-spans/keep.h"
#include <stdlib.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif

//> Ask the C library to keep memory
// Nothing is mapped for one array alone, and nothing trimmed.
void memory_keep(void)
{
#ifdef __GLIBC__
    mallopt(M_MMAP_MAX, 0);
    mallopt(M_TRIM_THRESHOLD, -1);
#endif
}
//<
//<

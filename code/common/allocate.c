//> Allocate or fail
// One array after the other from the C library, in multiples of a cache
// line, or of a large page: so no array shares a line with another.
#include "common/allocate.h"
#include "common/fail.h"
#include <stdint.h>
#include <stdlib.h>
#include <sys/mman.h>

//> Ask for large pages
static void ask_for_large_pages(void *memory, size_t bytes)
{
#ifdef MADV_HUGEPAGE
    madvise(memory, bytes, MADV_HUGEPAGE);
#else
    (void)memory, (void)bytes;
#endif
}
//<

//> Get memory or give up
// The system hands out memory in pages of 4 KB, when each is touched
// for the first time. Large arrays want large ones: 2 MB on most
// machines.
#define LARGE_PAGE ((size_t)2 << 20)

void *allocate(size_t count, size_t size)
{
    if (size && count > (SIZE_MAX - LARGE_PAGE) / size)
        fail("%zu times %zu bytes are too many", count, size);
    size_t bytes = count * size;
    size_t unit = bytes < LARGE_PAGE ? 64 : LARGE_PAGE;
    bytes = bytes ? (bytes + unit - 1) / unit * unit : unit;
    void *memory = aligned_alloc(unit, bytes);
    if (!memory)
        fail("no memory for %zu bytes", bytes);
    if (unit == LARGE_PAGE)
        ask_for_large_pages(memory, bytes);
    return memory;
}
//<
//<

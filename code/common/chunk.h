//> Cut indices into chunks
// Work on n indices is dealt out in chunks, one for each thread that
// was asked for, however many there really are. No two differ in length
// by more than one.
#pragma once
#include <stdint.h>

// Where chunk k begins, 0 <= k < chunks. It ends where k + 1 begins;
// chunk_begin(n, chunks, chunks) is n.
static inline uint32_t chunk_begin(uint32_t n, int k, int chunks)
{
    return (uint64_t)n * k / chunks;
}
//<

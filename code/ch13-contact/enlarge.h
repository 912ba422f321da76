//> Enlarge an array
// For arrays that grow by a factor when they are full: then adding to
// them takes constant time on average.
#pragma once
#include "common/allocate.h"
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

// An array with room for so many elements of this size, with the used
// ones of the old array, which is released; that may be NULL.
static inline void *enlarge(void *old, uint64_t used, uint64_t room,
                            size_t size)
{
    void *array = allocate(room, size);
    if (used > 0)
        memcpy(array, old, used * size);
    free(old);
    return array;
}
//<

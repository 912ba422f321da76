//> Declare the caches
// The sizes of the data caches in bytes, as the C library reports them;
// where it does not, those of an ordinary processor.
#pragma once
#include <stddef.h>

struct caches {
    size_t l1, l2, l3;
};

struct caches caches_of_machine(void);
//<

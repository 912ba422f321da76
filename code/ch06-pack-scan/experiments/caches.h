// The sizes of the first processor's data caches in bytes, as Linux
// reports them; elsewhere, those of an ordinary processor. (The C
// library knows them, too, but on a machine cut out of a larger one it
// may take the larger one's third cache for ours.)
#pragma once
#include <stddef.h>

struct caches {
    size_t l1, l2, l3;
};

struct caches caches_of_machine(void);

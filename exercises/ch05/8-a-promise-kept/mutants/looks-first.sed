# It looks whether a byte must be cleared, in all of the array.
# expect: to look at a page is to touch it
# why: A write is avoided where nothing is to do; a look is thought to be free.
s/return memset(memory.*/for (size_t k = 0; k < bytes; k++)\
        if (memory[begin + k])\
            memory[begin + k] = 0;\
    return (void)used, memory + begin;/

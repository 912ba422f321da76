# What is given up goes back to the system.
# expect: Were they given back to the system
# why: It is good manners to give back what is not needed.
s/#include <string.h>/&\
#include <sys\/mman.h>/; s/    top = height;/    size_t from = (height + 4095) \/ 4096 * 4096;\
    if (from < top)\
        madvise(memory + from, top - from, MADV_DONTNEED);\
&/

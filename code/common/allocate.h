//> Declare the allocation
// Memory that is there, or the end of the program: no caller has to ask
// whether it got any.
#pragma once
#include <stddef.h>

// Memory for count elements of size bytes each, 64-byte aligned, not
// cleared; never NULL. Released with free(). From 2 MB on, in whole
// large pages where the system has them. Fails if memory is short, or
// if so many bytes cannot be numbered.
void *allocate(size_t count, size_t size);
//<

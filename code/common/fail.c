//> Fail in one place
// The program's name and what to clean up are not passed as arguments,
// because fail must work from anywhere. A program has one of each, so
// the counting twin has none of its own and uses these.
#include "fail.h"
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#ifndef COUNTING
//> Say one sentence and end
static const char *name = "near";
static void (*clean_up)(void);

void fail_as(const char *program, void (*cleanup)(void))
{
    name = program;
    clean_up = cleanup;
}

_Noreturn void fail(const char *format, ...)
{
#pragma omp critical(fail) // threads may run out of memory together
    {
        va_list arguments;
        va_start(arguments, format);
        fprintf(stderr, "%s: ", name);
        vfprintf(stderr, format, arguments);
        fprintf(stderr, "\n");
        va_end(arguments);
        if (clean_up)
            clean_up();
        exit(2);
    }
}
//<

//> Get memory or give up
void *allocate(size_t count, size_t size)
{
    if (size && count > (SIZE_MAX - 63) / size)
        fail("%zu times %zu bytes are too many", count, size);
    size_t bytes = (count * size + 63) / 64 * 64;
    void *memory = aligned_alloc(64, bytes ? bytes : 64);
    if (!memory)
        fail("no memory for %zu bytes", bytes);
    return memory;
}
//<
#endif
//<

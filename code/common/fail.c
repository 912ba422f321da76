//> Fail in one place
// The program's name is not passed as an argument, because fail must
// work from anywhere. A program has one, so the counting twin has none
// of its own and uses this.
#include "common/fail.h"
#include <errno.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>

#ifndef COUNTING
//> Say one sentence and end
static const char *name = "near";
static bool failed;

static void finish_output(void)
{
    if ((ferror(stdout) | (fflush(stdout) != 0)) && !failed) {
        fprintf(stderr, "%s: cannot write standard output: %s\n", name,
                strerror(errno));
        _Exit(2);
    }
}

void fail_as(const char *program)
{
    name = program;
    atexit(finish_output);
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
        failed = true;
        exit(2);
    }
}
//<

//> Ask for large pages
// The system hands out memory in pages of 4 KB, when each is touched
// for the first time. Large arrays want large ones: 2 MB on most
// machines.
#define LARGE_PAGE ((size_t)2 << 20)

static void prefer_large_pages(void *memory, size_t bytes)
{
#ifdef MADV_HUGEPAGE
    madvise(memory, bytes, MADV_HUGEPAGE);
#else
    (void)memory, (void)bytes;
#endif
}
//<

//> Get memory or give up
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
        prefer_large_pages(memory, bytes);
    return memory;
}
//<
#endif
//<

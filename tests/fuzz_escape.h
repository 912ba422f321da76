// For programs that libFuzzer runs: fail() leaves by a jump, with its
// sentence, and gives all memory back. The program sets run.back before
// it calls what may fail; what that calls free is release (-Dfree).
#pragma once
#undef free
#include "common/allocate.h"
#include "common/fail.h"
#include <setjmp.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_BLOCKS = 100, MOST_BYTES = 1 << 28 };
static struct {
    jmp_buf back;
    char sentence[4096];
    void *blocks[MOST_BLOCKS];
} run;

_Noreturn void fail(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(run.sentence, sizeof run.sentence, format, arguments);
    va_end(arguments);
    longjmp(run.back, 1);
}

void *allocate(size_t count, size_t size)
{
    int k = 0;
    if (count > MOST_BYTES / size)
        fail("no memory");
    while (run.blocks[k])
        k++;
    return run.blocks[k] = malloc(count * size ? count * size : 1);
}

// What the readers call free.
void release(void *block)
{
    for (int k = 0; block && k < MOST_BLOCKS; k++)
        if (run.blocks[k] == block)
            run.blocks[k] = NULL;
    free(block);
}

// All that a reading that failed has taken.
static void release_all(void)
{
    for (int k = 0; k < MOST_BLOCKS; k++)
        release(run.blocks[k]);
}

//> Fail in one place
// Prints one sentence and ends the program, from any thread. The
// program's name is not passed as an argument, because fail must work
// from anywhere.
#include "common/fail.h"
#include <errno.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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
//<

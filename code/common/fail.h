//> Declare the one way to fail
// A user's mistake, or a machine without memory, ends the program
// here: one clear sentence on stderr, exit status 2.
#pragma once
#include <stddef.h>

// Prints "PROGRAM: " and the sentence, and runs the cleanup that was
// registered, so that nothing half written stays behind.
_Noreturn void fail(const char *format, ...)
    __attribute__((format(printf, 1, 2)));

// Called once by main. The cleanup may be NULL.
void fail_as(const char *program, void (*cleanup)(void));

// Memory for count elements of size bytes each, 64-byte aligned, not
// cleared; never NULL. Released with free(). From 2 MB on, in whole
// large pages where the system has them.
void *allocate(size_t count, size_t size);
//<

//> Declare the one way to fail
// A user's mistake, or a machine without memory, ends the program
// here: one clear sentence on stderr, exit status 2.
#pragma once
#include "common/allocate.h"

// Prints "PROGRAM: " and the sentence, and ends the program by exit, so
// that what atexit knows of is cleaned up.
_Noreturn void fail(const char *format, ...)
    __attribute__((format(printf, 1, 2)));

// Called once by main. From then on the program also fails at its end
// if its standard output could not be written.
void fail_as(const char *program);
//<

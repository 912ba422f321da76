//> Declare the arguments of an experiment
// An experiment takes whole numbers, how many points, how many trials,
// and has a number of its own for each that is left out.
#pragma once
#include <stdint.h>

// More points, rows or trials than anybody waits for, and few enough
// for an int.
enum { MANY = 1000000000 };

// Argument k of main, from least to most; where there are not so many,
// the number otherwise, or most if that is less. Fails with the name of
// the argument, what was expected and what was found.
uint32_t argument(int argc, char **argv, int k, const char *name,
                  uint32_t otherwise, uint32_t least, uint32_t most);
//<

// The job with its numbers read and written by the C library: what is
// defined here is not taken from the library of modules.
#include "common/numbers.c"
#define WAY "plain"
#define KINDS 1 // text
#include "ch01-workbench/experiments/job.c"

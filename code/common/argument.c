//> Read an experiment's arguments
// See argument.h. 2e4 is a whole number, too.
#include "common/argument.h"
#include "common/fail.h"
#include <inttypes.h>
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

uint32_t argument(int argc, char **argv, int k, const char *name,
                  uint32_t otherwise, uint32_t least, uint32_t most)
{
    if (argc <= k)
        return otherwise < most ? otherwise : most;
    char *end;
    double number = strtod(argv[k], &end);
    bool whole = end > argv[k] && !*end && number == floor(number);
    if (!whole || number < least || number > most)
        fail("expected %s from %" PRIu32 " to %" PRIu32
             ", found \"%s\"",
             name, least, most, argv[k]);
    return (uint32_t)number;
}
//<

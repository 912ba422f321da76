// Includes a device that never answers.
// score: 0
// says: it does not compile
#include "/dev/ptmx"
#include "right.h"

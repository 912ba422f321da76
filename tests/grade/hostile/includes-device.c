// Includes a file without an end.
// score: 0
// says: it does not compile
#include "/dev/zero"
#include "right.h"

// Includes a file without an end.
// score: 0
// says: ties
#include "/dev/zero"
#include "right.h"

// Includes the solution.
// score: 0
// says: it does not compile
#include "../exercises/ch02/1-nearest-pair/solution.c"
#include "right.h"

// Includes the tests, and prints them.
// score: 0
// says: it does not compile
#include "../exercises/ch02/1-nearest-pair/tests.c"
#include "right.h"

struct pair nearest_pair(struct points points)
{
    return right(points);
}

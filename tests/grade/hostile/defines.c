// Has the preprocessor rename everything.
// score: 0
// says: not define the function
#include "right.h"
#define nearest_pair kit_tests
#define double float
#define main nearest_pair
#define return for (;;)

struct pair nearest_pair(struct points points)
{
    return right(points);
}

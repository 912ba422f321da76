// Grows while it is compiled.
// score: 0
// says: it does not compile
#include "right.h"
#define A(x) x x x x x x x x x x
#define B(x) A(A(A(x)))
int v[] = {B(B(B(0, )))};

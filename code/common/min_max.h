//> Take the smaller, take the larger
// Of two numbers, in the wider type of the two. The one that is chosen
// is computed twice, so there must be no call and no ++ in it. Where a
// is NAN, it is b.
#pragma once

#define MIN(a, b) ((a) < (b) ? (a) : (b))
#define MAX(a, b) ((a) > (b) ? (a) : (b))
//<

// Join neighbors to pairs, scan the pairs in the same way, and fill in
// what is between: 2 n joins, and two levels more each time n doubles.
// The back half of the result has room for the pairs, because a scan
// never needs its last element.
#include "exercise.h"

void scan(uint32_t n, const struct sum *from, struct sum *to)
{
    //- solution
    if (n < 2) {
        if (n == 1)
            to[0] = nothing;
        return;
    }
    uint32_t half = (n + 1) / 2;
    struct sum *pairs = to + half;
    for (uint32_t i = 0; i < half - 1; i++)
        pairs[i] = join(from[2 * i], from[2 * i + 1]);
    scan(half, pairs, to);
    for (uint32_t i = half; i-- > 0;) { // to[i] moves to the back
        if (2 * i + 1 < n)
            to[2 * i + 1] = join(to[i], from[2 * i]);
        to[2 * i] = to[i];
    }
    //- starter
    // // Your turn. So far: right, and as slow as can be.
    // for (uint32_t i = 0; i < n; i++)
    //     to[i] = i == 0 ? nothing : join(to[i - 1], from[i - 1]);
    //- end
}

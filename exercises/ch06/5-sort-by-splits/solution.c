// A stable split takes a single scan: of the i values before value i,
// those that are not ones are zeros. A sort is a split by every bit,
// the lowest first.
#include "exercise.h"

struct vector split(struct vector values, struct vector flags)
{
    //- solution
    uint32_t n = values.n;
    struct sums ones = scan(flags);
    struct vector zeros = subtract(numbers(n), ones.before);
    struct vector first = constant(n, n - ones.total);
    struct vector places =
        choose(flags, add(first, ones.before), zeros);
    return scatter(values, places);
    //- starter
    // // Your turn. So far: everything stays where it is.
    // return scatter(values, numbers(flags.n));
    //- end
}

struct vector sort(struct vector keys, int bits)
{
    //- solution
    for (int k = 0; k < bits; k++)
        keys = split(keys, bit(keys, k));
    return keys;
    //- starter
    // // Your turn. So far: one split, by bit 0.
    // return split(keys, bit(keys, 0));
    //- end
}

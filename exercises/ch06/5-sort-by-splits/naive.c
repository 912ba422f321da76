// Two packs, one with the flags turned round.
// expect: 4 of 10
#include "exercise.h"

struct vector split(struct vector values, struct vector flags)
{
    uint32_t n = values.n;
    struct vector turned = subtract(constant(n, 1), flags);
    struct sums zeros = scan(turned), ones = scan(flags);
    struct vector behind = add(ones.before, constant(n, zeros.total));
    return scatter(values, choose(flags, behind, zeros.before));
}

struct vector sort(struct vector keys, int bits)
{
    for (int k = 0; k < bits; k++)
        keys = split(keys, bit(keys, k));
    return keys;
}

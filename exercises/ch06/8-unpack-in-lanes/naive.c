// One number after the other, without a branch.
// expect: 4 of 10
#include "exercise.h"

void unpack(uint32_t n, const uint8_t *keep, const uint32_t *from,
            uint32_t *to, uint32_t hole)
{
    uint32_t next = 0;
    for (uint32_t i = 0; i < n; i++) {
        uint32_t set = keep[i / 8] >> (i % 8) & 1;
        to[i] = set ? from[next] : hole;
        next += set;
    }
}

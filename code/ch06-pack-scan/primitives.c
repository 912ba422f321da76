//> Write the primitives in plain C
// Each primitive is a loop with one step an element, and no branch but
// the loop's. Where the compiler does not vectorize a loop, it is asked
// to unroll it: the time of a loop of six instructions may double with
// the address at which it happens to stand.
#include "ch06-pack-scan/primitives.h"
#include <assert.h>

//> Add element by element
void portable_add(double *to, const double *a, const double *b,
                  uint32_t n)
{
    for (uint32_t i = 0; i < n; i++)
        to[i] = a[i] + b[i];
}
//<

//> Gather through an index
void portable_gather(double *to, const double *from,
                     const uint32_t *index, uint32_t n)
{
#pragma GCC unroll 4
    for (uint32_t i = 0; i < n; i++)
        to[i] = from[index[i]];
}
//<

//> Gather numbers of 32 bits
void portable_gather32(uint32_t *to, const uint32_t *from,
                       const uint32_t *index, uint32_t n)
{
#pragma GCC unroll 4
    for (uint32_t i = 0; i < n; i++)
        to[i] = from[index[i]];
}
//<

//> Scatter through an index
void portable_scatter(double *to, const double *from,
                      const uint32_t *index, uint32_t n)
{
#pragma GCC unroll 4
    for (uint32_t i = 0; i < n; i++)
        to[index[i]] = from[i];
}
//<

//> Scatter numbers of 32 bits
void portable_scatter32(uint32_t *to, const uint32_t *from,
                        const uint32_t *index, uint32_t n)
{
#pragma GCC unroll 4
    for (uint32_t i = 0; i < n; i++)
        to[index[i]] = from[i];
}
//<

//> Scan one by one
uint32_t portable_scan(uint32_t *to, const uint32_t *from, uint32_t n,
                       uint32_t sum)
{
#pragma GCC unroll 4
    for (uint32_t i = 0; i < n; i++) {
        uint32_t here = from[i]; // the arrays may be the same
        to[i] = sum;
        sum += here;
    }
    return sum;
}
//<

//> Pack without a branch
uint32_t portable_pack(uint32_t *to, const uint32_t *from,
                       const uint8_t *keep, uint32_t n)
{
    uint32_t k = 0;
#pragma GCC unroll 4
    for (uint32_t i = 0; i < n; i++) {
        to[k] = from[i]; // the next one overwrites it, or not
        k += keep[i];
    }
    return k;
}
//<

//> List the portable primitives
const struct primitives portable_primitives = {
    .isa = PORTABLE,
    .add = portable_add,
    .gather = portable_gather,
    .gather32 = portable_gather32,
    .scatter = portable_scatter,
    .scatter32 = portable_scatter32,
    .scan = portable_scan,
    .pack = portable_pack,
};
//<

//> Look up the table of an instruction set
const struct primitives *primitives(enum isa isa)
{
    static const struct primitives *const tables[ISA_COUNT] =
        FOR_EACH_ISA(&portable_primitives, &avx2_primitives,
                     &avx512_primitives);
    assert(isa_present(isa) && "its instructions would be illegal");
    return tables[isa];
}
//<
//<

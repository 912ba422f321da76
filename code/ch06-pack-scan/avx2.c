//> Write the primitives in AVX2
// Whole vectors, eight 32-bit numbers or four doubles at a time, as
// long as they last; then the portable functions do the rest. A scan
// takes three steps a vector (Kogge and Stone 1973), a pack one
// permutation, which is computed by packing the lanes' numbers.
#include "ch06-pack-scan/primitives.h"
#ifdef HAVE_X86_VECTORS
#include <immintrin.h>
#include <string.h>

//> Add four at a time
USE_AVX2
static void add(double *to, const double *a, const double *b,
                uint32_t n)
{
    uint32_t whole = n / 4 * 4;
#pragma GCC unroll 4
    for (uint32_t i = 0; i < whole; i += 4)
        _mm256_storeu_pd(to + i, _mm256_add_pd(_mm256_loadu_pd(a + i),
                                               _mm256_loadu_pd(b + i)));
    portable_add(to + whole, a + whole, b + whole, n - whole);
}
//<

//> Sum up a vector from the left
// Lane i becomes the sum of lanes 0 to i.
USE_AVX2
static __m256i sums(__m256i x)
{
    const __m256i lane_3 = _mm256_set1_epi32(3);
    x = _mm256_add_epi32(x, _mm256_slli_si256(x, 4));
    x = _mm256_add_epi32(x, _mm256_slli_si256(x, 8));
    __m256i low = _mm256_permutevar8x32_epi32(x, lane_3);
    return _mm256_add_epi32(
        x, _mm256_blend_epi32(_mm256_setzero_si256(), low, 0xf0));
}
//<

//> Scan eight at a time
USE_AVX2
static uint32_t scan(uint32_t *to, const uint32_t *from, uint32_t n,
                     uint32_t sum)
{
    const __m256i last = _mm256_set1_epi32(7);
    uint32_t whole = n / 8 * 8;
    __m256i before = _mm256_set1_epi32((int)sum);
    for (uint32_t i = 0; i < whole; i += 8) {
        __m256i x = _mm256_loadu_si256((const __m256i *)(from + i));
        __m256i up_to = sums(x);
        _mm256_storeu_si256(
            (__m256i *)(to + i),
            _mm256_add_epi32(before, _mm256_sub_epi32(up_to, x)));
        before = _mm256_add_epi32(
            before, _mm256_permutevar8x32_epi32(up_to, last));
    }
    sum = (uint32_t)_mm256_cvtsi256_si32(before);
    return portable_scan(to + whole, from + whole, n - whole, sum);
}
//<

//> Pack eight at a time
USE_AVX2
static uint32_t pack(uint32_t *to, const uint32_t *from,
                     const uint8_t *keep, uint32_t n)
{
    uint32_t whole = n / 8 * 8, k = 0;
    for (uint32_t i = 0; i < whole; i += 8) {
        uint64_t flags;
        memcpy(&flags, keep + i, 8);
        uint64_t lanes = _pext_u64(0x0706050403020100, flags * 0xff);
        __m256i order =
            _mm256_cvtepu8_epi32(_mm_cvtsi64_si128((long long)lanes));
        __m256i x = _mm256_loadu_si256((const __m256i *)(from + i));
        _mm256_storeu_si256((__m256i *)(to + k),
                            _mm256_permutevar8x32_epi32(x, order));
        k += (uint32_t)__builtin_popcountll(flags);
    }
    return k +
           portable_pack(to + k, from + whole, keep + whole, n - whole);
}
//<

//> List the primitives in AVX2
// A route is a load or a store for each element, and plain C has both.
const struct primitives avx2_primitives = {
    .isa = AVX2,
    .add = add,
    .gather = portable_gather,
    .gather32 = portable_gather32,
    .scatter = portable_scatter,
    .scatter32 = portable_scatter32,
    .scan = scan,
    .pack = pack,
};
//<
#endif
//<

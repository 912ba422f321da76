//> Write the primitives in AVX-512
// Sixteen 32-bit numbers or eight doubles at a time. Loads and stores
// of scan and pack have a mask of the lanes that they touch, so that
// the last vector, which is seldom full, needs no loop of its own.
#include "ch06-pack-scan/primitives.h"
#ifdef HAVE_X86_VECTORS
#include <immintrin.h>
#include <stddef.h>

//> Mask what is left
// One bit for each lane that still has an element.
USE_AVX512
static __mmask16 up_to_last(size_t left)
{
    return left < 16 ? (__mmask16)((1u << left) - 1) : 0xffff;
}
//<

//> Add eight at a time
USE_AVX512
static void add(double *to, const double *a, const double *b,
                uint32_t n)
{
    uint32_t whole = n / 8 * 8;
#pragma GCC unroll 4
    for (uint32_t i = 0; i < whole; i += 8)
        _mm512_storeu_pd(to + i, _mm512_add_pd(_mm512_loadu_pd(a + i),
                                               _mm512_loadu_pd(b + i)));
    portable_add(to + whole, a + whole, b + whole, n - whole);
}
//<

//> Sum up sixteen lanes from the left
// Lane i becomes the sum of lanes 0 to i.
USE_AVX512
static __m512i sums(__m512i x)
{
    const __m512i zero = _mm512_setzero_si512();
    x = _mm512_add_epi32(x, _mm512_alignr_epi32(x, zero, 15));
    x = _mm512_add_epi32(x, _mm512_alignr_epi32(x, zero, 14));
    x = _mm512_add_epi32(x, _mm512_alignr_epi32(x, zero, 12));
    return _mm512_add_epi32(x, _mm512_alignr_epi32(x, zero, 8));
}
//<

//> Scan sixteen at a time
USE_AVX512
static uint32_t scan(uint32_t *to, const uint32_t *from, uint32_t n,
                     uint32_t sum)
{
    const __m512i last = _mm512_set1_epi32(15);
    __m512i before = _mm512_set1_epi32((int)sum);
    for (size_t i = 0; i < n; i += 16) {
        __mmask16 here = up_to_last(n - i);
        __m512i x = _mm512_maskz_loadu_epi32(here, from + i);
        __m512i up_to = sums(x);
        _mm512_mask_storeu_epi32(
            to + i, here,
            _mm512_add_epi32(before, _mm512_sub_epi32(up_to, x)));
        before = _mm512_add_epi32(
            before, _mm512_permutexvar_epi32(last, up_to));
    }
    return (uint32_t)_mm512_cvtsi512_si32(before);
}
//<

//> Pack sixteen at a time
USE_AVX512
static uint32_t pack(uint32_t *to, const uint32_t *from,
                     const uint8_t *keep, uint32_t n)
{
    uint32_t k = 0;
    for (size_t i = 0; i < n; i += 16) {
        __mmask16 here = up_to_last(n - i);
        __m128i flags = _mm_maskz_loadu_epi8(here, keep + i);
        __mmask16 kept = _mm_test_epi8_mask(flags, flags);
        __m512i x = _mm512_maskz_compress_epi32(
            kept, _mm512_maskz_loadu_epi32(here, from + i));
        _mm512_mask_storeu_epi32(to + k, here, x);
        k += (uint32_t)__builtin_popcount(kept);
    }
    return k;
}
//<

//> List the primitives in AVX-512
// It has instructions for routes. They still load or store a number for
// each element, and plain C does that as fast, or faster.
const struct primitives avx512_primitives = {
    .isa = AVX512,
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

//> Write the primitives in AVX-512
// See avx512.h. Every load and store has a mask of the lanes that it
// touches, so that what is left over at the end is nothing special.
#include "ch06-pack-scan/avx512.h"
#ifdef HAVE_X86_VECTORS
#include <immintrin.h>
#include <stddef.h>

//> Mask what is left
USE_AVX512
static __mmask8 up_to_8(size_t left)
{
    return left < 8 ? (__mmask8)((1u << left) - 1) : 0xff;
}

USE_AVX512
static __mmask16 up_to_16(size_t left)
{
    return left < 16 ? (__mmask16)((1u << left) - 1) : 0xffff;
}
//<

//> Add eight at a time
USE_AVX512
static void add(double *to, const double *a, const double *b,
                uint32_t n)
{
    for (size_t i = 0; i < n; i += 8) {
        __mmask8 here = up_to_8(n - i);
        __m512d sum = _mm512_add_pd(_mm512_maskz_loadu_pd(here, a + i),
                                    _mm512_maskz_loadu_pd(here, b + i));
        _mm512_mask_storeu_pd(to + i, here, sum);
    }
}
//<

//> Load eight indices
USE_AVX512
static __m512i eight(__mmask8 here, const uint32_t *index)
{
    return _mm512_cvtepu32_epi64(_mm256_maskz_loadu_epi32(here, index));
}
//<

//> Gather eight at a time
USE_AVX512
static void gather(double *to, const double *from,
                   const uint32_t *index, uint32_t n)
{
    for (size_t i = 0; i < n; i += 8) {
        __mmask8 here = up_to_8(n - i);
        __m512d x = _mm512_mask_i64gather_pd(
            _mm512_setzero_pd(), here, eight(here, index + i), from, 8);
        _mm512_mask_storeu_pd(to + i, here, x);
    }
}
//<

//> Gather eight 32-bit numbers at a time
USE_AVX512
static void gather32(uint32_t *to, const uint32_t *from,
                     const uint32_t *index, uint32_t n)
{
    for (size_t i = 0; i < n; i += 8) {
        __mmask8 here = up_to_8(n - i);
        __m256i x = _mm512_mask_i64gather_epi32(
            _mm256_setzero_si256(), here, eight(here, index + i), from,
            4);
        _mm256_mask_storeu_epi32(to + i, here, x);
    }
}
//<

//> Scatter eight at a time
USE_AVX512
static void scatter(double *to, const double *from,
                    const uint32_t *index, uint32_t n)
{
    for (size_t i = 0; i < n; i += 8) {
        __mmask8 here = up_to_8(n - i);
        _mm512_mask_i64scatter_pd(to, here, eight(here, index + i),
                                  _mm512_maskz_loadu_pd(here, from + i),
                                  8);
    }
}
//<

//> Scatter eight 32-bit numbers at a time
USE_AVX512
static void scatter32(uint32_t *to, const uint32_t *from,
                      const uint32_t *index, uint32_t n)
{
    for (size_t i = 0; i < n; i += 8) {
        __mmask8 here = up_to_8(n - i);
        _mm512_mask_i64scatter_epi32(
            to, here, eight(here, index + i),
            _mm256_maskz_loadu_epi32(here, from + i), 4);
    }
}
//<

//> Scan sixteen at a time
USE_AVX512
static __m512i sums(__m512i x)
{
    const __m512i zero = _mm512_setzero_si512();
    x = _mm512_add_epi32(x, _mm512_alignr_epi32(x, zero, 15));
    x = _mm512_add_epi32(x, _mm512_alignr_epi32(x, zero, 14));
    x = _mm512_add_epi32(x, _mm512_alignr_epi32(x, zero, 12));
    return _mm512_add_epi32(x, _mm512_alignr_epi32(x, zero, 8));
}

USE_AVX512
static uint32_t scan(uint32_t *to, const uint32_t *from, uint32_t n,
                     uint32_t sum)
{
    const __m512i last = _mm512_set1_epi32(15);
    __m512i before = _mm512_set1_epi32((int)sum);
    for (size_t i = 0; i < n; i += 16) {
        __mmask16 here = up_to_16(n - i);
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
        __mmask16 here = up_to_16(n - i);
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
const struct primitives avx512_primitives = {
    .isa = AVX512,
    .add = add,
    .gather = gather,
    .gather32 = gather32,
    .scatter = scatter,
    .scatter32 = scatter32,
    .scan = scan,
    .pack = pack,
};
//<
#endif
//<

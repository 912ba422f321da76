//> Move and narrow lanes in AVX2
// What AVX2 has no single instruction for: loads and stores without a
// cast, routes of four, masks of four lanes in either width.
#pragma once
#include "common/isa.h"
#include <immintrin.h>
#include <stdint.h>

//> Load and store eight numbers
USE_AVX2
static inline __m256i eight(const void *from)
{
    return _mm256_loadu_si256((const __m256i *)from);
}

USE_AVX2
static inline void put(void *to, __m256i x)
{
    _mm256_storeu_si256((__m256i *)to, x);
}
//<

//> Gather and scatter four
USE_AVX2
static inline __m256d four(const double *from, const uint32_t *index)
{
    return _mm256_set_pd(from[index[3]], from[index[2]], from[index[1]],
                         from[index[0]]);
}

USE_AVX2
static inline __m128i four32(const uint32_t *from,
                             const uint32_t *index)
{
    return _mm_set_epi32((int)from[index[3]], (int)from[index[2]],
                         (int)from[index[1]], (int)from[index[0]]);
}

USE_AVX2
static inline void put_four(double *to, const uint32_t *index,
                            __m256d x)
{
    __m128d low = _mm256_castpd256_pd128(x);
    __m128d high = _mm256_extractf128_pd(x, 1);
    _mm_storel_pd(to + index[0], low);
    _mm_storeh_pd(to + index[1], low);
    _mm_storel_pd(to + index[2], high);
    _mm_storeh_pd(to + index[3], high);
}

USE_AVX2
static inline void put_four32(uint32_t *to, const uint32_t *index,
                              __m128i x)
{
    to[index[0]] = (uint32_t)_mm_cvtsi128_si32(x);
    to[index[1]] = (uint32_t)_mm_extract_epi32(x, 1);
    to[index[2]] = (uint32_t)_mm_extract_epi32(x, 2);
    to[index[3]] = (uint32_t)_mm_extract_epi32(x, 3);
}
//<

//> Narrow and widen masks
USE_AVX2
static inline __m128i narrow(__m256d lanes)
{
    __m128 low = _mm_castpd_ps(_mm256_castpd256_pd128(lanes));
    __m128 high = _mm_castpd_ps(_mm256_extractf128_pd(lanes, 1));
    return _mm_castps_si128(_mm_shuffle_ps(low, high, 0x88));
}

USE_AVX2
static inline __m256d widen(__m128i lanes)
{
    return _mm256_castsi256_pd(_mm256_cvtepi32_epi64(lanes));
}
//<
//<

// Stands in for the compiler's <immintrin.h> in tests/instructions:
// every instruction is a function in plain C, whatever the processor.
// Most are SIMDe's. The rest, which version 0.7.4 of it lacks, are
// here, written from Intel's description: lanes whose bit in the mask
// is 0 are not loaded or stored, nor is their memory touched.
#pragma once
#define SIMDE_NO_NATIVE
#define SIMDE_ENABLE_NATIVE_ALIASES
#include <simde/x86/avx2.h>
#include <simde/x86/avx512.h>
#include <stdint.h>
#include <string.h>

#undef __mmask8
#define __mmask8 simde__mmask8
#undef __mmask16
#define __mmask16 simde__mmask16

// ---- masked loads and stores ---------------------------------------
#define EMULATED_LOAD_STORE(name, vector, mask_type, type)             \
    static inline vector emulated_load_##name(mask_type mask,          \
                                              const void *from)        \
    {                                                                  \
        type lanes[sizeof(vector) / sizeof(type)] = {0};               \
        for (unsigned i = 0; i < sizeof(vector) / sizeof(type); i++)   \
            if (mask >> i & 1)                                         \
                memcpy(&lanes[i],                                      \
                       (const char *)from + i * sizeof(type),          \
                       sizeof(type));                                  \
        vector result;                                                 \
        memcpy(&result, lanes, sizeof result);                         \
        return result;                                                 \
    }                                                                  \
    static inline void emulated_store_##name(void *to, mask_type mask, \
                                             vector x)                 \
    {                                                                  \
        type lanes[sizeof(vector) / sizeof(type)];                     \
        memcpy(lanes, &x, sizeof lanes);                               \
        for (unsigned i = 0; i < sizeof(vector) / sizeof(type); i++)   \
            if (mask >> i & 1)                                         \
                memcpy((char *)to + i * sizeof(type), &lanes[i],       \
                       sizeof(type));                                  \
    }
EMULATED_LOAD_STORE(bytes, __m128i, uint32_t, uint8_t)
EMULATED_LOAD_STORE(eight32, __m256i, uint32_t, uint32_t)
EMULATED_LOAD_STORE(sixteen32, __m512i, uint32_t, uint32_t)
EMULATED_LOAD_STORE(eight, __m512d, uint32_t, double)

#undef _mm_maskz_loadu_epi8
#define _mm_maskz_loadu_epi8 emulated_load_bytes
#undef _mm256_maskz_loadu_epi32
#define _mm256_maskz_loadu_epi32 emulated_load_eight32
#undef _mm256_mask_storeu_epi32
#define _mm256_mask_storeu_epi32 emulated_store_eight32
#undef _mm512_maskz_loadu_epi32
#define _mm512_maskz_loadu_epi32 emulated_load_sixteen32
#undef _mm512_mask_storeu_epi32
#define _mm512_mask_storeu_epi32 emulated_store_sixteen32
#undef _mm512_maskz_loadu_pd
#define _mm512_maskz_loadu_pd emulated_load_eight
#undef _mm512_mask_storeu_pd
#define _mm512_mask_storeu_pd emulated_store_eight

// AVX2 masks lanes by their signs. SIMDe has these, but reads all
// lanes, those beyond the end of an array, too.
static inline __m256d emulated_load_four(const double *from,
                                         __m256i mask)
{
    int64_t sign[4];
    double to[4] = {0};
    memcpy(sign, &mask, sizeof sign);
    for (int i = 0; i < 4; i++)
        if (sign[i] < 0)
            to[i] = from[i];
    return _mm256_loadu_pd(to);
}
#undef _mm256_maskload_pd
#define _mm256_maskload_pd emulated_load_four

static inline __m128i emulated_load_four32(const int32_t *from,
                                           __m128i mask)
{
    int32_t sign[4], to[4] = {0};
    memcpy(sign, &mask, sizeof sign);
    for (int i = 0; i < 4; i++)
        if (sign[i] < 0)
            to[i] = from[i];
    return _mm_loadu_si128((const __m128i *)to);
}
#undef _mm_maskload_epi32
#define _mm_maskload_epi32 emulated_load_four32

// ---- gather and scatter --------------------------------------------
#define EMULATED_ROUTES(name, vector, type)                          \
    static inline vector emulated_gather_##name(                     \
        vector otherwise, uint32_t mask, __m512i index,              \
        const void *from, int scale)                                 \
    {                                                                \
        int64_t places[8];                                           \
        memcpy(places, &index, sizeof places);                       \
        type lanes[8];                                               \
        memcpy(lanes, &otherwise, sizeof lanes);                     \
        for (unsigned i = 0; i < 8; i++)                             \
            if (mask >> i & 1)                                       \
                memcpy(&lanes[i],                                    \
                       (const char *)from + places[i] * scale,       \
                       sizeof(type));                                \
        vector result;                                               \
        memcpy(&result, lanes, sizeof result);                       \
        return result;                                               \
    }                                                                \
    static inline void emulated_scatter_##name(                      \
        void *to, uint32_t mask, __m512i index, vector x, int scale) \
    {                                                                \
        int64_t places[8];                                           \
        memcpy(places, &index, sizeof places);                       \
        type lanes[8];                                               \
        memcpy(lanes, &x, sizeof lanes);                             \
        for (unsigned i = 0; i < 8; i++)                             \
            if (mask >> i & 1)                                       \
                memcpy((char *)to + places[i] * scale, &lanes[i],    \
                       sizeof(type));                                \
    }
EMULATED_ROUTES(doubles, __m512d, double)
EMULATED_ROUTES(numbers, __m256i, uint32_t)
EMULATED_ROUTES(pairs, __m512i, uint64_t)

#undef _mm512_mask_i64gather_pd
#define _mm512_mask_i64gather_pd emulated_gather_doubles
#undef _mm512_mask_i64gather_epi32
#define _mm512_mask_i64gather_epi32 emulated_gather_numbers
#undef _mm512_mask_i64gather_epi64
#define _mm512_mask_i64gather_epi64 emulated_gather_pairs
#undef _mm512_mask_i64scatter_pd
#define _mm512_mask_i64scatter_pd emulated_scatter_doubles
#undef _mm512_mask_i64scatter_epi32
#define _mm512_mask_i64scatter_epi32 emulated_scatter_numbers

// ---- masked comparisons --------------------------------------------
#define EMULATED_COMPARE(name, vector, type, op)                    \
    static inline simde__mmask8 emulated_##name(simde__mmask8 mask, \
                                                vector a, vector b) \
    {                                                               \
        type x[8], y[8];                                            \
        simde__mmask8 result = 0;                                   \
        memcpy(x, &a, sizeof x);                                    \
        memcpy(y, &b, sizeof y);                                    \
        for (unsigned i = 0; i < 8; i++)                            \
            result |= (simde__mmask8)((x[i] op y[i]) << i);         \
        return result & mask;                                       \
    }
EMULATED_COMPARE(not_less, __m256i, int32_t, >=)
EMULATED_COMPARE(not_equal, __m256i, int32_t, !=)
EMULATED_COMPARE(not_above, __m256i, uint32_t, <=)
EMULATED_COMPARE(less, __m512d, double, <)
EMULATED_COMPARE(equal, __m512d, double, ==)

#undef _mm256_mask_cmpge_epi32_mask
#define _mm256_mask_cmpge_epi32_mask emulated_not_less
#undef _mm256_mask_cmpneq_epi32_mask
#define _mm256_mask_cmpneq_epi32_mask emulated_not_equal
#undef _mm256_mask_cmple_epu32_mask
#define _mm256_mask_cmple_epu32_mask emulated_not_above
#undef _mm512_mask_cmplt_pd_mask
#define _mm512_mask_cmplt_pd_mask emulated_less
#undef _mm512_mask_cmpeq_pd_mask
#define _mm512_mask_cmpeq_pd_mask emulated_equal

// ---- within registers ----------------------------------------------
static inline __m512i emulated_widen(__m256i x)
{
    uint32_t narrow[8];
    uint64_t wide[8];
    memcpy(narrow, &x, sizeof narrow);
    for (int i = 0; i < 8; i++)
        wide[i] = narrow[i];
    __m512i result;
    memcpy(&result, wide, sizeof result);
    return result;
}
#undef _mm512_cvtepu32_epi64
#define _mm512_cvtepu32_epi64 emulated_widen

static inline __m256 emulated_single(__m512d x)
{
    double wide[8];
    float narrow[8];
    memcpy(wide, &x, sizeof wide);
    for (int i = 0; i < 8; i++)
        narrow[i] = (float)wide[i];
    __m256 result;
    memcpy(&result, narrow, sizeof result);
    return result;
}
#undef _mm512_cvtpd_ps
#define _mm512_cvtpd_ps emulated_single

// The sixteen lanes from number `by` on of b, followed by a.
static inline __m512i emulated_align(__m512i a, __m512i b, int by)
{
    uint32_t both[32];
    memcpy(both, &b, sizeof b);
    memcpy(both + 16, &a, sizeof a);
    __m512i result;
    memcpy(&result, both + by, sizeof result);
    return result;
}
#undef _mm512_alignr_epi32
#define _mm512_alignr_epi32 emulated_align

static inline int emulated_lowest(__m512i x)
{
    int lowest;
    memcpy(&lowest, &x, sizeof lowest);
    return lowest;
}
#undef _mm512_cvtsi512_si32
#define _mm512_cvtsi512_si32 emulated_lowest

static inline uint16_t emulated_test_bytes(__m128i a, __m128i b)
{
    uint8_t x[16], y[16];
    uint16_t mask = 0;
    memcpy(x, &a, sizeof x);
    memcpy(y, &b, sizeof y);
    for (unsigned i = 0; i < 16; i++)
        mask |= (uint16_t)(((x[i] & y[i]) != 0) << i);
    return mask;
}
#undef _mm_test_epi8_mask
#define _mm_test_epi8_mask emulated_test_bytes

static inline uint64_t emulated_extract(uint64_t bits, uint64_t mask)
{
    uint64_t result = 0;
    for (unsigned i = 0, k = 0; i < 64; i++)
        if (mask >> i & 1)
            result |= (bits >> i & 1) << k++;
    return result;
}
#undef _pext_u64
#define _pext_u64 emulated_extract

static inline uint64_t emulated_deposit(uint64_t bits, uint64_t mask)
{
    uint64_t result = 0;
    for (unsigned i = 0, k = 0; i < 64; i++)
        if (mask >> i & 1)
            result |= (bits >> k++ & 1) << i;
    return result;
}
#undef _pdep_u64
#define _pdep_u64 emulated_deposit

//> Go along with AVX-512
// See tile.h: sixteen floats, or eight doubles, at a time.
#include "ch09-row-spans/avx512_spans.h"
#include "common/isa.h"
#ifdef HAVE_X86_VECTORS
#include "ch09-row-spans/tile.h"
#include <immintrin.h>

//> Stage eight with a mask
USE_AVX512
INLINED void stage(const struct sorted *sorted, uint32_t begin,
                   uint32_t end, double x, double y,
                   struct table *table)
{
    const struct points p = sorted->points;
    const __m512d from_x = _mm512_set1_pd(x),
                  from_y = _mm512_set1_pd(y);
    const __m256i lane = _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7);
    uint32_t k = table->count;
    table->count += end - begin;
    for (uint32_t s = begin; s < end; s += 8, k += 8) {
        uint32_t left = end - s;
        __mmask8 there = (__mmask8)(left < 8 ? (1u << left) - 1 : 255);
        __m512d dx = _mm512_sub_pd(
            _mm512_maskz_loadu_pd(there, p.x + s), from_x);
        __m512d dy = _mm512_sub_pd(
            _mm512_maskz_loadu_pd(there, p.y + s), from_y);
        _mm256_storeu_ps(table->x + k, _mm512_cvtpd_ps(dx));
        _mm256_storeu_ps(table->y + k, _mm512_cvtpd_ps(dy));
        _mm256_storeu_si256(
            (__m256i *)(table->place + k),
            _mm256_add_epi32(_mm256_set1_epi32((int)s), lane));
    }
}
//<

//> Show two candidates to eight
// Lanes 2 q and 2 q + 1 are for who asks as number q, and show him a
// candidate each.
struct two {
    __m512 best, second;
};

USE_AVX512
INLINED void keep_two(struct two *two, __m512 d2)
{
    __m512 loser = _mm512_max_ps(two->best, d2);
    two->best = _mm512_min_ps(two->best, d2);
    two->second = _mm512_min_ps(two->second, loser);
}

USE_AVX512
INLINED __m512 pair_from(const float *from)
{
    int64_t bits;
    memcpy(&bits, from, sizeof bits);
    return _mm512_castsi512_ps(_mm512_set1_epi64(bits));
}

USE_AVX512
INLINED __m512 numbered(const struct table *table, uint32_t k,
                        __m512i number, __m512 x, __m512 y)
{
    enum { FIRST_WITHOUT_SECOND_OR_THIRD = 0xba };
    __m512 dx = _mm512_sub_ps(pair_from(table->x + k), x);
    __m512 dy = _mm512_sub_ps(pair_from(table->y + k), y);
    __m512 d2 =
        _mm512_add_ps(_mm512_mul_ps(dx, dx), _mm512_mul_ps(dy, dy));
    return _mm512_castsi512_ps(_mm512_ternarylogic_epi32(
        _mm512_castps_si512(d2), _mm512_set1_epi32(NUMBER_BITS), number,
        FIRST_WITHOUT_SECOND_OR_THIRD));
}
//<

//> Join the two halves
USE_AVX512
INLINED void join(const struct two *two, struct sieve *sieve)
{
    const __m512i even = _mm512_setr_epi32(0, 2, 4, 6, 8, 10, 12, 14, 0,
                                           2, 4, 6, 8, 10, 12, 14);
    const __m512i odd = _mm512_add_epi32(even, _mm512_set1_epi32(1));
    struct two joined = {_mm512_permutexvar_ps(even, two->best),
                         _mm512_permutexvar_ps(even, two->second)};
    keep_two(&joined, _mm512_permutexvar_ps(odd, two->best));
    joined.second = _mm512_min_ps(
        joined.second, _mm512_permutexvar_ps(odd, two->second));
    _mm256_storeu_ps(sieve->best, _mm512_castps512_ps256(joined.best));
    _mm256_storeu_ps(sieve->second,
                     _mm512_castps512_ps256(joined.second));
}
//<

//> Sift with sixteen floats
USE_AVX512
INLINED void sift(const struct table *table, struct sieve *sieve)
{
    const __m512i twice = _mm512_setr_epi32(0, 0, 1, 1, 2, 2, 3, 3, 4,
                                            4, 5, 5, 6, 6, 7, 7);
    const __m512 x = _mm512_permutexvar_ps(
        twice, _mm512_castps256_ps512(_mm256_loadu_ps(table->x)));
    const __m512 y = _mm512_permutexvar_ps(
        twice, _mm512_castps256_ps512(_mm256_loadu_ps(table->y)));
    const __m512 far2 = _mm512_set1_ps(FAR2);
    const __m512i more = _mm512_set1_epi32(2);
    __m512i number = _mm512_setr_epi32(0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0,
                                       1, 0, 1, 0, 1);
    struct two two = {far2, far2};
    uint32_t k = 0;
    for (; k < ASKING; k += 2) {
        __mmask16 self = _mm512_cmpeq_epi32_mask(twice, number);
        __m512 d2 = numbered(table, k, number, x, y);
        keep_two(&two, _mm512_mask_mov_ps(d2, self, far2));
        number = _mm512_add_epi32(number, more);
    }
    while (k < table->count)
        for (int step = 0; step < STEPS; step += 2, k += 2) {
            keep_two(&two, numbered(table, k, number, x, y));
            number = _mm512_add_epi32(number, more);
        }
    join(&two, sieve);
}
//<

//> Meet eight at a time
struct eight {
    __m512d best2;
    __m512i nearest, self;
};

USE_AVX512
INLINED __m512d eight_near2(const enum geometry geometry,
                            struct space space, __m512d dx, __m512d dy)
{
    __m512d ax2 = _mm512_mul_pd(dx, dx), ay2 = _mm512_mul_pd(dy, dy);
    if (geometry == STANDARD)
        return _mm512_add_pd(ax2, ay2);
    __m512d bx =
        _mm512_sub_pd(_mm512_set1_pd(space.width), _mm512_abs_pd(dx));
    __m512d by =
        _mm512_sub_pd(_mm512_set1_pd(space.height), _mm512_abs_pd(dy));
    return _mm512_add_pd(_mm512_min_pd(ax2, _mm512_mul_pd(bx, bx)),
                         _mm512_min_pd(ay2, _mm512_mul_pd(by, by)));
}

USE_AVX512
INLINED void eight_keep(struct eight *eight, __m512d d2, __m512i who,
                        __mmask8 there)
{
    __mmask8 less = _mm512_cmp_pd_mask(d2, eight->best2, _CMP_LT_OQ);
    __mmask8 same = _mm512_cmp_pd_mask(d2, eight->best2, _CMP_EQ_OQ);
    __mmask8 first = _mm512_cmpgt_epi64_mask(eight->nearest, who);
    __mmask8 self = _mm512_cmpeq_epi64_mask(who, eight->self);
    __mmask8 better =
        (__mmask8)((less | (same & first)) & ~self & there);
    eight->best2 = _mm512_mask_mov_pd(eight->best2, better, d2);
    eight->nearest = _mm512_mask_mov_epi64(eight->nearest, better, who);
}

USE_AVX512
INLINED void meet(const enum geometry geometry, struct space space,
                  const struct sorted *sorted, uint32_t begin,
                  uint32_t end, struct single *single)
{
    const struct points p = sorted->points;
    const uint32_t *point = sorted->cells.point;
    const __m512d x = _mm512_set1_pd(single->x);
    const __m512d y = _mm512_set1_pd(single->y);
    struct eight eight = {_mm512_set1_pd(single->best2),
                          _mm512_set1_epi64(single->nearest),
                          _mm512_set1_epi64(single->self)};
    for (uint32_t s = begin; s < end; s += 8) {
        uint32_t left = end - s;
        __mmask8 there = (__mmask8)(left < 8 ? (1u << left) - 1 : 255);
        __m512d d2 = eight_near2(
            geometry, space,
            _mm512_sub_pd(_mm512_maskz_loadu_pd(there, p.x + s), x),
            _mm512_sub_pd(_mm512_maskz_loadu_pd(there, p.y + s), y));
        __m256i who = _mm256_maskz_loadu_epi32(there, point + s);
        eight_keep(&eight, d2, _mm512_cvtepu32_epi64(who), there);
    }
    double best2[8];
    uint64_t nearest[8];
    _mm512_storeu_pd(best2, eight.best2);
    _mm512_storeu_si512(nearest, eight.nearest);
    for (int lane = 0; lane < 8; lane++)
        single_keep(single, best2[lane], (uint32_t)nearest[lane]);
}
//<

USE_AVX512
void avx512_spans(const struct question *question,
                  const struct sorted *sorted, enum manner manner,
                  uint32_t begin, uint32_t end, struct answers *found)
{
    if (question->space.geometry == STANDARD)
        go(STANDARD, stage, sift, meet, question->space, sorted, manner,
           begin, end, found);
    else
        go(WRAPAROUND, stage, sift, meet, question->space, sorted,
           manner, begin, end, found);
}
#endif
//<

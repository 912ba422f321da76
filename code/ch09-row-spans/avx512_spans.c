//> Go along with AVX-512
// See tile.h: sixteen floats, or eight doubles, at a time.
#include "ch09-row-spans/avx512_spans.h"
#include "common/isa.h"
#ifdef HAVE_X86_VECTORS
#include "ch09-row-spans/avx512_window.h"

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
    for (uint64_t s = begin; s < end; s += 8, k += 8) {
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

//> See near with sixteen floats
USE_AVX512
INLINED __m512 see_near(const struct wide_eye *eye, __m512 dx,
                        __m512 dy)
{
    (void)eye;
    return _mm512_fmadd_ps(dx, dx, _mm512_mul_ps(dy, dy));
}

USE_AVX512
INLINED uint32_t glance(const enum geometry geometry,
                        struct space space, const struct sorted *sorted,
                        const struct window *window,
                        const struct tile *tile, struct reply *reply)
{
    struct sieve sieve;
    sweep_wide(see_near, space, sorted, window, tile, &sieve);
    return reply_to_eight(settle, geometry, space,
                          near_slack(tile->reach), sorted, window, tile,
                          &sieve, reply);
}
//<

//> Sift with sixteen floats
USE_AVX512
INLINED void sift(const struct table *table, struct sieve *sieve)
{
    struct wide_eye eye =
        wide_eye_for((struct space){0}, table->x, table->y);
    uint32_t number[2] = {0, 1};
    for (uint32_t k = 0; k < ASKING; k += 2) {
        number[0] = k, number[1] = k + 1;
        __m512 seen = glance_at_two(see_near, &eye, table->x + k,
                                    table->y + k, number);
        keep_wide(&eye.wide, nobody_self(seen, k));
    }
    for (uint32_t k = ASKING; k < table->count; k += 2) {
        number[0] = k, number[1] = k + 1;
        keep_wide(&eye.wide, glance_at_two(see_near, &eye, table->x + k,
                                           table->y + k, number));
    }
    join(&eye.wide, sieve);
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
    for (uint64_t s = begin; s < end; s += 8) {
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

//> Go by windows with AVX-512
USE_AVX512
void avx512_spans(const struct question *question,
                  const struct sorted *sorted, enum manner manner,
                  const struct visit *visit, uint32_t begin,
                  uint32_t end, struct answers *found)
{
    const struct space space = question->space;
    if (manner == TOGETHER && space.geometry == STANDARD)
        go_by_windows(STANDARD, stage, sift, frame, glance, meet, space,
                      sorted, visit, begin, end, found);
    else if (manner == TOGETHER)
        go_by_windows(WRAPAROUND, stage, sift, frame, glance, meet,
                      space, sorted, visit, begin, end, found);
    else if (space.geometry == STANDARD)
        go(STANDARD, stage, sift, meet, space, sorted, manner, visit,
           begin, end, found);
    else
        go(WRAPAROUND, stage, sift, meet, space, sorted, manner, visit,
           begin, end, found);
}
//<
#endif
//<

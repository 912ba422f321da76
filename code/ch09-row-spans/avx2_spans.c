//> Go along with AVX2
// See tile.h: eight floats, or four doubles, at a time.
#include "ch09-row-spans/avx2_spans.h"
#include "common/isa.h"
#ifdef HAVE_X86_VECTORS
#include "ch09-row-spans/avx2_window.h"

//> Stage eight at a time
// Where fewer than eight are left in memory, plainly.
USE_AVX2
INLINED void stage(const struct sorted *sorted, uint32_t begin,
                   uint32_t end, double x, double y,
                   struct table *table)
{
    const struct points p = sorted->points;
    const __m256d from_x = _mm256_set1_pd(x),
                  from_y = _mm256_set1_pd(y);
    const __m256i lane = _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7);
    uint32_t s = begin, k = table->count;
    for (; s < end && p.n - s >= 8; s += 8, k += 8) {
        __m256i place =
            _mm256_add_epi32(_mm256_set1_epi32((int)s), lane);
        _mm256_storeu_ps(table->x + k, eight_from(p.x + s, from_x));
        _mm256_storeu_ps(table->y + k, eight_from(p.y + s, from_y));
        _mm256_storeu_si256((__m256i *)(table->place + k), place);
    }
    if (s < end)
        stage_plainly(sorted, s, end, x, y, k, table);
    table->count += end - begin;
}
//<

//> Show a candidate to eight
// The low bits of the distances make room for the candidate's number.
USE_AVX2
INLINED __m256 numbered(const struct table *table, uint32_t k,
                        __m256i number, __m256 x, __m256 y)
{
    __m256 dx = _mm256_sub_ps(_mm256_broadcast_ss(table->x + k), x);
    __m256 dy = _mm256_sub_ps(_mm256_broadcast_ss(table->y + k), y);
    __m256 d2 =
        _mm256_add_ps(_mm256_mul_ps(dx, dx), _mm256_mul_ps(dy, dy));
    __m256i high = _mm256_andnot_si256(_mm256_set1_epi32(NUMBER_BITS),
                                       _mm256_castps_si256(d2));
    return _mm256_castsi256_ps(_mm256_or_si256(high, number));
}
//<

//> Sift with eight floats
USE_AVX2
INLINED void sift(const struct table *table, struct sieve *sieve)
{
    const __m256 x = _mm256_loadu_ps(table->x);
    const __m256 y = _mm256_loadu_ps(table->y);
    const __m256 far2 = _mm256_set1_ps(FAR2);
    const __m256i one = _mm256_set1_epi32(1);
    const __m256i lane = _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7);
    struct two two = {far2, far2};
    __m256i number = _mm256_setzero_si256();
    uint32_t k = 0;
    for (; k < ASKING; k++) {
        __m256i self = _mm256_cmpeq_epi32(lane, number);
        __m256 d2 = numbered(table, k, number, x, y);
        keep_two(&two,
                 _mm256_blendv_ps(d2, far2, _mm256_castsi256_ps(self)));
        number = _mm256_add_epi32(number, one);
    }
    while (k < table->count)
        for (int step = 0; step < STEPS; step++, k++) {
            keep_two(&two, numbered(table, k, number, x, y));
            number = _mm256_add_epi32(number, one);
        }
    _mm256_storeu_ps(sieve->best, two.best);
    _mm256_storeu_ps(sieve->second, two.second);
}
//<

//> Meet four at a time
// A lane's best and its index stay in registers.
struct four {
    __m256d best2;
    __m256i nearest, self;
};

//> Keep best and index in registers
USE_AVX2
INLINED void four_keep(struct four *four, __m256d d2, __m256i who,
                       __m256i there)
{
    __m256d less = _mm256_cmp_pd(d2, four->best2, _CMP_LT_OQ);
    __m256d same = _mm256_cmp_pd(d2, four->best2, _CMP_EQ_OQ);
    __m256d first =
        _mm256_castsi256_pd(_mm256_cmpgt_epi64(four->nearest, who));
    __m256i better = _mm256_castpd_si256(
        _mm256_or_pd(less, _mm256_and_pd(same, first)));
    better = _mm256_andnot_si256(_mm256_cmpeq_epi64(who, four->self),
                                 _mm256_and_si256(better, there));
    four->best2 =
        _mm256_blendv_pd(four->best2, d2, _mm256_castsi256_pd(better));
    four->nearest = _mm256_blendv_epi8(four->nearest, who, better);
}
//<

USE_AVX2
INLINED void four_answer(const struct four *four, struct single *single)
{
    double best2[4];
    uint64_t nearest[4];
    _mm256_storeu_pd(best2, four->best2);
    _mm256_storeu_si256((__m256i *)nearest, four->nearest);
    for (int lane = 0; lane < 4; lane++)
        single_keep(single, best2[lane], (uint32_t)nearest[lane]);
}

USE_AVX2
INLINED void meet(const enum geometry geometry, struct space space,
                  const struct sorted *sorted, uint32_t begin,
                  uint32_t end, struct single *single)
{
    const struct points p = sorted->points;
    const __m256d x = _mm256_set1_pd(single->x);
    const __m256d y = _mm256_set1_pd(single->y);
    const __m128i lane = _mm_setr_epi32(0, 1, 2, 3);
    struct four four = {_mm256_set1_pd(single->best2),
                        _mm256_set1_epi64x(single->nearest),
                        _mm256_set1_epi64x(single->self)};
    for (uint64_t s = begin; s < end; s += 4) {
        int left = (int)(end - s < 4 ? end - s : 4);
        __m128i there = _mm_cmpgt_epi32(_mm_set1_epi32(left), lane);
        __m256i wide = _mm256_cvtepi32_epi64(there);
        __m256d d2 = four_near2(
            geometry, space,
            _mm256_sub_pd(_mm256_maskload_pd(p.x + s, wide), x),
            _mm256_sub_pd(_mm256_maskload_pd(p.y + s, wide), y));
        __m128i who = _mm_maskload_epi32(
            (const int *)(sorted->cells.point + s), there);
        four_keep(&four, d2, _mm256_cvtepu32_epi64(who), wide);
    }
    four_answer(&four, single);
}
//<

//> Sweep and reply for the nearest
USE_AVX2
INLINED __m256 see_near(const struct eye *eye, __m256 dx, __m256 dy)
{
    (void)eye;
    return _mm256_fmadd_ps(dx, dx, _mm256_mul_ps(dy, dy));
}

USE_AVX2
INLINED uint32_t glance(const enum geometry geometry,
                        struct space space, const struct sorted *sorted,
                        const struct window *window,
                        const struct tile *tile, struct reply *reply)
{
    struct sieve sieve;
    sweep(see_near, space, sorted, window, tile, &sieve);
    return reply_to_eight(settle, geometry, space,
                          near_slack(tile->reach), sorted, window, tile,
                          &sieve, reply);
}
//<

//> Go by windows with AVX2
USE_AVX2
void avx2_spans(const struct question *question,
                const struct sorted *sorted, enum manner manner,
                const struct visit *visit, uint32_t begin, uint32_t end,
                struct answers *found)
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

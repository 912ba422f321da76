//> Go along with AVX2
// See tile.h: eight floats, or four doubles, at a time.
#include "ch09-row-spans/avx2_spans.h"
#include "common/isa.h"
#ifdef HAVE_X86_VECTORS
#include "ch09-row-spans/window.h"
#include <immintrin.h>

//> Stage eight at a time
// Where fewer than eight are left in memory, plainly.
USE_AVX2
INLINED __m256 eight_from(const double *x, __m256d origin)
{
    __m256d low = _mm256_sub_pd(_mm256_loadu_pd(x), origin);
    __m256d high = _mm256_sub_pd(_mm256_loadu_pd(x + 4), origin);
    return _mm256_set_m128(_mm256_cvtpd_ps(high), _mm256_cvtpd_ps(low));
}

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

//> Keep the two smallest
struct two {
    __m256 best, second;
};

USE_AVX2
INLINED void keep_two(struct two *two, __m256 d2)
{
    __m256 loser = _mm256_max_ps(two->best, d2);
    two->best = _mm256_min_ps(two->best, d2);
    two->second = _mm256_min_ps(two->second, loser);
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

//> Frame a row
// Eight at a time, as long as there are eight in memory.
USE_AVX2
INLINED void frame(const struct sorted *sorted, struct span span,
                   double x, double y, struct frame *frame)
{
    const struct points p = sorted->points;
    const __m256d from_x = _mm256_set1_pd(x),
                  from_y = _mm256_set1_pd(y);
    const __m256 far = _mm256_set1_ps(FAR);
    uint32_t s = span.begin, k = SPILLED;
    frame->begin = span.begin;
    _mm256_storeu_ps(frame->x, far);
    _mm256_storeu_ps(frame->y, far);
    for (; s < span.end && p.n - s >= 8; s += 8, k += 8) {
        _mm256_storeu_ps(frame->x + k, eight_from(p.x + s, from_x));
        _mm256_storeu_ps(frame->y + k, eight_from(p.y + s, from_y));
    }
    for (; s < span.end; s++, k++) {
        frame->x[k] = (float)(p.x[s] - x);
        frame->y[k] = (float)(p.y[s] - y);
    }
    k = SPILLED + (span.end - span.begin);
    for (int more = 0; more < 2; more++, k += SPILLED) {
        _mm256_storeu_ps(frame->x + k, far);
        _mm256_storeu_ps(frame->y + k, far);
    }
}
//<

//> Glance at four candidates
struct eye {
    __m256 own_x, own_y;
    struct two two;
};

USE_AVX2
INLINED __m256 glance_at(const struct eye *eye, const float *x,
                         const float *y, const uint32_t *number)
{
    __m256 dx = _mm256_sub_ps(_mm256_broadcast_ss(x), eye->own_x);
    __m256 dy = _mm256_sub_ps(_mm256_broadcast_ss(y), eye->own_y);
    __m256 d2 = _mm256_fmadd_ps(dx, dx, _mm256_mul_ps(dy, dy));
    return _mm256_castsi256_ps(_mm256_blendv_epi8(
        _mm256_castps_si256(d2), _mm256_set1_epi32((int)*number),
        _mm256_set1_epi32(NUMBER_BITS)));
}

USE_AVX2
INLINED void glance_along(const struct frame *frame,
                          const uint32_t *number, uint32_t begin,
                          uint32_t end, struct eye *eye)
{
    for (uint32_t k = begin; k < end; k += EACH) {
        const float *x = frame->x + k, *y = frame->y + k;
        const uint32_t *here = number + k;
#pragma GCC unroll 4
        for (int step = 0; step < EACH; step++)
            keep_two(&eye->two,
                     glance_at(eye, x + step, y + step, here + step));
    }
}
//<

//> Glance at those who ask
// Nobody meets himself.
USE_AVX2
INLINED void glance_at_own(const struct frame *frame,
                           const uint32_t *number, uint32_t own,
                           struct eye *eye)
{
    const __m256 far2 = _mm256_set1_ps(FAR2);
    const __m256i lane = _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7);
    const float *x = frame->x + own, *y = frame->y + own;
#pragma GCC unroll 8
    for (int k = 0; k < ASKING; k++) {
        __m256i self = _mm256_cmpeq_epi32(lane, _mm256_set1_epi32(k));
        __m256 d2 = glance_at(eye, x + k, y + k, number + own + k);
        keep_two(&eye->two,
                 _mm256_blendv_ps(d2, far2, _mm256_castsi256_ps(self)));
    }
}
//<

//> Sweep over three spans
USE_AVX2
INLINED void sweep(const struct window *window,
                   const struct glance *glance, struct sieve *sieve)
{
    const struct frame *frame = window->frame;
    const uint32_t *number = window->number, own = glance->own;
    const uint32_t before = (own - glance->begin[1] + EACH - 1) / EACH;
    const __m256 far2 = _mm256_set1_ps(FAR2);
    struct eye eye = {.own_x = _mm256_loadu_ps(frame[1].x + own),
                      .own_y = _mm256_loadu_ps(frame[1].y + own),
                      .two = {far2, far2}};
    glance_along(frame, number, glance->begin[0], glance->end[0], &eye);
    number += FRAME;
    glance_along(frame + 1, number, own - before * EACH, own, &eye);
    glance_at_own(frame + 1, number, own, &eye);
    glance_along(frame + 1, number, own + ASKING, glance->end[1], &eye);
    number += FRAME;
    glance_along(frame + 2, number, glance->begin[2], glance->end[2],
                 &eye);
    _mm256_storeu_ps(sieve->best, eye.two.best);
    _mm256_storeu_ps(sieve->second, eye.two.second);
}
//<

//> Meet four at a time
// A lane's best and its index stay in registers.
struct four {
    __m256d best2;
    __m256i nearest, self;
};

USE_AVX2
INLINED __m256d four_near2(const enum geometry geometry,
                           struct space space, __m256d dx, __m256d dy)
{
    __m256d ax2 = _mm256_mul_pd(dx, dx), ay2 = _mm256_mul_pd(dy, dy);
    if (geometry == STANDARD)
        return _mm256_add_pd(ax2, ay2);
    const __m256d sign = _mm256_set1_pd(-0.0);
    __m256d bx = _mm256_sub_pd(_mm256_set1_pd(space.width),
                               _mm256_andnot_pd(sign, dx));
    __m256d by = _mm256_sub_pd(_mm256_set1_pd(space.height),
                               _mm256_andnot_pd(sign, dy));
    return _mm256_add_pd(_mm256_min_pd(ax2, _mm256_mul_pd(bx, bx)),
                         _mm256_min_pd(ay2, _mm256_mul_pd(by, by)));
}

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
    for (uint32_t s = begin; s < end; s += 4) {
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

//> Find who the numbers are
USE_AVX2
INLINED __m256i eight_places(const struct window *window,
                             const struct sieve *sieve, uint32_t n)
{
    const struct frame *frame = window->frame;
    const __m256i zero =
        _mm256_set1_epi32((int)(frame[0].begin - SPILLED));
    const __m256i one =
        _mm256_set1_epi32((int)(frame[1].begin - SPILLED - FRAME));
    const __m256i two =
        _mm256_set1_epi32((int)(frame[2].begin - SPILLED - 2 * FRAME));
    __m256i number = _mm256_and_si256(
        _mm256_loadu_si256((const __m256i *)sieve->best),
        _mm256_set1_epi32(NUMBER_BITS));
    __m256i from = _mm256_blendv_epi8(
        zero, one,
        _mm256_cmpgt_epi32(number, _mm256_set1_epi32(FRAME - 1)));
    from = _mm256_blendv_epi8(
        from, two,
        _mm256_cmpgt_epi32(number, _mm256_set1_epi32(2 * FRAME - 1)));
    return _mm256_min_epu32(_mm256_add_epi32(from, number),
                            _mm256_set1_epi32((int)(n - 1)));
}
//<

//> Find four margins
USE_AVX2
INLINED __m256d four_margins2(const enum geometry geometry,
                              const struct sorted *sorted,
                              const struct tile *tile, __m256d x,
                              __m256d y, uint32_t at)
{
    if (geometry == WRAPAROUND) {
        double margin2[4];
        for (uint32_t k = 0; k < 4; k++) {
            double margin = block_margin(&sorted->grid, &tile->block,
                                         sorted->points.x[at + k],
                                         sorted->points.y[at + k]);
            margin2[k] = margin * margin;
        }
        return _mm256_loadu_pd(margin2);
    }
    const struct reach *across = &tile->block.x, *up = &tile->block.y;
    __m256d left = _mm256_sub_pd(x, _mm256_set1_pd(across->below.high));
    __m256d right = _mm256_sub_pd(_mm256_set1_pd(across->above.low), x);
    __m256d below = _mm256_sub_pd(y, _mm256_set1_pd(up->below.high));
    __m256d above = _mm256_sub_pd(_mm256_set1_pd(up->above.low), y);
    __m256d margin = _mm256_min_pd(_mm256_min_pd(left, right),
                                   _mm256_min_pd(below, above));
    return _mm256_mul_pd(margin, margin);
}
//<

//> Reply to four
// Returns four bits: whose distance is less than his margin.
USE_AVX2
INLINED uint32_t reply_to_four(const enum geometry geometry,
                               struct space space,
                               const struct sorted *sorted,
                               const struct tile *tile, int first,
                               const uint32_t t[4], struct reply *reply)
{
    const double *x = sorted->points.x, *y = sorted->points.y;
    const uint32_t at = tile->begin + (uint32_t)first;
    __m256d to_x = _mm256_setr_pd(x[t[0]], x[t[1]], x[t[2]], x[t[3]]);
    __m256d to_y = _mm256_setr_pd(y[t[0]], y[t[1]], y[t[2]], y[t[3]]);
    __m256d own_x = _mm256_loadu_pd(x + at);
    __m256d own_y = _mm256_loadu_pd(y + at);
    __m256d near2 =
        four_near2(geometry, space, _mm256_sub_pd(to_x, own_x),
                   _mm256_sub_pd(to_y, own_y));
    __m256d margin2 =
        four_margins2(geometry, sorted, tile, own_x, own_y, at);
    _mm256_storeu_pd(reply->near2 + first, near2);
    for (int k = 0; k < 4; k++)
        reply->who[first + k] = sorted->cells.point[t[k]];
    return (uint32_t)_mm256_movemask_pd(
        _mm256_cmp_pd(near2, margin2, _CMP_LT_OQ));
}
//<

//> Reply to eight
USE_AVX2
INLINED uint32_t reply(const enum geometry geometry, struct space space,
                       const struct sorted *sorted,
                       const struct tile *tile,
                       const struct window *window,
                       const struct sieve *sieve, struct reply *reply)
{
    uint32_t place[ASKING];
    _mm256_storeu_si256((__m256i *)place,
                        eight_places(window, sieve, sorted->points.n));
    __m256 best = _mm256_loadu_ps(sieve->best);
    __m256 bound =
        _mm256_add_ps(_mm256_mul_ps(best, _mm256_set1_ps(1 + 0x1p-12f)),
                      _mm256_set1_ps(reply->slack));
    uint32_t sure = (uint32_t)_mm256_movemask_ps(_mm256_cmp_ps(
        _mm256_loadu_ps(sieve->second), bound, _CMP_GT_OQ));
    uint32_t low =
        reply_to_four(geometry, space, sorted, tile, 0, place, reply);
    uint32_t high = reply_to_four(geometry, space, sorted, tile, 4,
                                  place + 4, reply);
    return sure & (low | high << 4);
}
//<

//> Go by windows with AVX2
USE_AVX2
void avx2_spans(const struct question *question,
                const struct sorted *sorted, enum manner manner,
                uint32_t begin, uint32_t end, struct answers *found)
{
    const struct space space = question->space;
    if (manner == TOGETHER && space.geometry == STANDARD)
        go_by_windows(STANDARD, stage, sift, frame, sweep, reply, meet,
                      space, sorted, begin, end, found);
    else if (manner == TOGETHER)
        go_by_windows(WRAPAROUND, stage, sift, frame, sweep, reply,
                      meet, space, sorted, begin, end, found);
    else if (space.geometry == STANDARD)
        go(STANDARD, stage, sift, meet, space, sorted, manner, begin,
           end, found);
    else
        go(WRAPAROUND, stage, sift, meet, space, sorted, manner, begin,
           end, found);
}
//<
#endif
//<

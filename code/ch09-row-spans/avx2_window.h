//> Look through a window with AVX2
// See window.h: eight floats, or four doubles, at a time. What a
// candidate looks like, and who is sure, are the searcher's to say.
#pragma once
#include "ch09-row-spans/window.h"
#include "common/isa.h"
#include <immintrin.h>

//> Take eight coordinates
USE_AVX2
INLINED __m256 eight_from(const double *x, __m256d origin)
{
    __m256d low = _mm256_sub_pd(_mm256_loadu_pd(x), origin);
    __m256d high = _mm256_sub_pd(_mm256_loadu_pd(x + 4), origin);
    return _mm256_set_m128(_mm256_cvtpd_ps(high), _mm256_cvtpd_ps(low));
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
// The low bits of what is seen make room for the candidate's number.
struct eye {
    __m256 own_x, own_y;
    __m256 across, up; // twice the box
    struct two two;
};

// What to sift: the less, the better.
typedef __m256 see_function(const struct eye *eye, __m256 dx,
                            __m256 dy);

USE_AVX2
INLINED __m256 glance_at(see_function *see, const struct eye *eye,
                         const float *x, const float *y,
                         const uint32_t *number)
{
    __m256 seen =
        see(eye, _mm256_sub_ps(_mm256_broadcast_ss(x), eye->own_x),
            _mm256_sub_ps(_mm256_broadcast_ss(y), eye->own_y));
    return _mm256_castsi256_ps(_mm256_blendv_epi8(
        _mm256_castps_si256(seen), _mm256_set1_epi32((int)*number),
        _mm256_set1_epi32(NUMBER_BITS)));
}

USE_AVX2
INLINED void glance_along(see_function *see, const struct frame *frame,
                          const uint32_t *number, uint32_t begin,
                          uint32_t end, struct eye *eye)
{
    for (uint32_t k = begin; k < end; k += EACH) {
        const float *x = frame->x + k, *y = frame->y + k;
        const uint32_t *here = number + k;
#pragma GCC unroll 4
        for (int step = 0; step < EACH; step++)
            keep_two(&eye->two, glance_at(see, eye, x + step, y + step,
                                          here + step));
    }
}
//<

//> Glance at those who ask
// The eight that begin at x, y. Nobody meets himself.
USE_AVX2
INLINED void glance_at_own(see_function *see, const float *x,
                           const float *y, const uint32_t *number,
                           struct eye *eye)
{
    const __m256 far2 = _mm256_set1_ps(FAR2);
    const __m256i lane = _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7);
#pragma GCC unroll 8
    for (int k = 0; k < ASKING; k++) {
        __m256i self = _mm256_cmpeq_epi32(lane, _mm256_set1_epi32(k));
        __m256 seen = glance_at(see, eye, x + k, y + k, number + k);
        keep_two(&eye->two, _mm256_blendv_ps(
                                seen, far2, _mm256_castsi256_ps(self)));
    }
}
//<

//> Open an eye
// For the eight that begin at x, y.
USE_AVX2
INLINED struct eye eye_for(struct space space, const float *x,
                           const float *y)
{
    const __m256 far2 = _mm256_set1_ps(FAR2);
    return (struct eye){_mm256_loadu_ps(x),
                        _mm256_loadu_ps(y),
                        _mm256_set1_ps((float)(2 * space.width)),
                        _mm256_set1_ps((float)(2 * space.height)),
                        {far2, far2}};
}
//<

//> Sweep over three spans
USE_AVX2
INLINED void sweep(see_function *see, struct space space,
                   const struct sorted *sorted,
                   const struct window *window, const struct tile *tile,
                   struct sieve *sieve)
{
    const struct glance glance = point_out(sorted, window, tile);
    const struct frame *frame = window->frame;
    const uint32_t *number = window->number, own = glance.own;
    const uint32_t before = (own - glance.begin[1] + EACH - 1) / EACH;
    const float *x = frame[1].x + own, *y = frame[1].y + own;
    struct eye eye = eye_for(space, x, y);
    glance_along(see, frame, number, glance.begin[0], glance.end[0],
                 &eye);
    number += FRAME;
    glance_along(see, frame + 1, number, own - before * EACH, own,
                 &eye);
    glance_at_own(see, x, y, number + own, &eye);
    glance_along(see, frame + 1, number, own + ASKING, glance.end[1],
                 &eye);
    number += FRAME;
    glance_along(see, frame + 2, number, glance.begin[2], glance.end[2],
                 &eye);
    _mm256_storeu_ps(sieve->best, eye.two.best);
    _mm256_storeu_ps(sieve->second, eye.two.second);
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
// As reach_margin has them.
USE_AVX2
INLINED __m256d four_margins(const enum geometry geometry,
                             const struct axis *axis,
                             const struct reach *reach, __m256d x)
{
    __m256d direct = _mm256_min_pd(
        _mm256_sub_pd(x, _mm256_set1_pd(reach->below.high)),
        _mm256_sub_pd(_mm256_set1_pd(reach->above.low), x));
    if (geometry == STANDARD)
        return direct;
    __m256d furthest = _mm256_max_pd(
        _mm256_sub_pd(x, _mm256_set1_pd(reach->below.low)),
        _mm256_sub_pd(_mm256_set1_pd(reach->above.high), x));
    return _mm256_min_pd(
        direct, _mm256_sub_pd(_mm256_set1_pd(axis->period), furthest));
}
//<

//> Reply to four
// Those who ask, and how far away are whom the sieve names.
struct quartet {
    __m256d x, y, dx, dy;
};

// Computes four squared distances, and returns four bits: with whom
// nobody outside of the block can compete.
typedef uint32_t settle_function(const enum geometry geometry,
                                 struct space space,
                                 const struct grid *grid,
                                 const struct block *block,
                                 const struct quartet *four,
                                 double d2[4]);

USE_AVX2
INLINED uint32_t reply_to_four(settle_function *settle,
                               const enum geometry geometry,
                               struct space space,
                               const struct sorted *sorted,
                               const struct tile *tile, uint32_t first,
                               const uint32_t t[4], struct reply *reply)
{
    const double *x = sorted->points.x, *y = sorted->points.y;
    const uint32_t at = tile->begin + first;
    struct quartet four = {
        _mm256_loadu_pd(x + at), _mm256_loadu_pd(y + at),
        _mm256_setr_pd(x[t[0]], x[t[1]], x[t[2]], x[t[3]]),
        _mm256_setr_pd(y[t[0]], y[t[1]], y[t[2]], y[t[3]])};
    four.dx = _mm256_sub_pd(four.dx, four.x);
    four.dy = _mm256_sub_pd(four.dy, four.y);
    for (int k = 0; k < 4; k++)
        reply->who[first + k] = sorted->cells.point[t[k]];
    return settle(geometry, space, &sorted->grid, &tile->block, &four,
                  reply->d2 + first);
}
//<

//> Reply to eight
USE_AVX2
INLINED uint32_t reply_to_eight(
    settle_function *settle, const enum geometry geometry,
    struct space space, float slack, const struct sorted *sorted,
    const struct window *window, const struct tile *tile,
    const struct sieve *sieve, struct reply *reply)
{
    uint32_t place[ASKING];
    _mm256_storeu_si256((__m256i *)place,
                        eight_places(window, sieve, sorted->points.n));
    __m256 best = _mm256_loadu_ps(sieve->best);
    __m256 bound =
        _mm256_add_ps(_mm256_mul_ps(best, _mm256_set1_ps(1 + 0x1p-12f)),
                      _mm256_set1_ps(slack));
    uint32_t sure = (uint32_t)_mm256_movemask_ps(_mm256_cmp_ps(
        _mm256_loadu_ps(sieve->second), bound, _CMP_GT_OQ));
    uint32_t low = reply_to_four(settle, geometry, space, sorted, tile,
                                 0, place, reply);
    uint32_t high = reply_to_four(settle, geometry, space, sorted, tile,
                                  4, place + 4, reply);
    return sure & (low | high << 4);
}
//<

//> Settle four nearest
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

USE_AVX2
INLINED uint32_t settle(const enum geometry geometry,
                        struct space space, const struct grid *grid,
                        const struct block *block,
                        const struct quartet *four, double near2[4])
{
    __m256d d2 = four_near2(geometry, space, four->dx, four->dy);
    __m256d margin = _mm256_min_pd(
        four_margins(geometry, &grid->x, &block->x, four->x),
        four_margins(geometry, &grid->y, &block->y, four->y));
    _mm256_storeu_pd(near2, d2);
    return (uint32_t)_mm256_movemask_pd(
        _mm256_cmp_pd(d2, _mm256_mul_pd(margin, margin), _CMP_LT_OQ));
}
//<
//<

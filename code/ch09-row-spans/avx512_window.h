//> Look through a window with AVX-512
// As avx2_window.h, but two candidates at a time: lanes 2 q and 2 q + 1
// are for who asks as number q, and show him a candidate each.
#pragma once
#include "ch09-row-spans/avx2_window.h"

//> Keep twice the two smallest
struct wide {
    __m512 best, second;
};

USE_AVX512
INLINED void keep_wide(struct wide *wide, __m512 seen)
{
    __m512 loser = _mm512_max_ps(wide->best, seen);
    wide->best = _mm512_min_ps(wide->best, seen);
    wide->second = _mm512_min_ps(wide->second, loser);
}
//<

//> Join the two halves
USE_AVX512
INLINED void join(const struct wide *wide, struct sieve *sieve)
{
    const __m512i even = _mm512_setr_epi32(0, 2, 4, 6, 8, 10, 12, 14, 0,
                                           2, 4, 6, 8, 10, 12, 14);
    const __m512i odd = _mm512_add_epi32(even, _mm512_set1_epi32(1));
    struct wide joined = {_mm512_permutexvar_ps(even, wide->best),
                          _mm512_permutexvar_ps(even, wide->second)};
    keep_wide(&joined, _mm512_permutexvar_ps(odd, wide->best));
    joined.second = _mm512_min_ps(
        joined.second, _mm512_permutexvar_ps(odd, wide->second));
    _mm256_storeu_ps(sieve->best, _mm512_castps512_ps256(joined.best));
    _mm256_storeu_ps(sieve->second,
                     _mm512_castps512_ps256(joined.second));
}
//<

//> Open a wide eye
struct wide_eye {
    __m512 own_x, own_y;
    __m512 across, up; // twice the box
    struct wide wide;
};

USE_AVX512
INLINED struct wide_eye wide_eye_for(struct space space, const float *x,
                                     const float *y)
{
    const __m512i twice = _mm512_setr_epi32(0, 0, 1, 1, 2, 2, 3, 3, 4,
                                            4, 5, 5, 6, 6, 7, 7);
    const __m512 far2 = _mm512_set1_ps(FAR2);
    return (struct wide_eye){
        _mm512_permutexvar_ps(
            twice, _mm512_castps256_ps512(_mm256_loadu_ps(x))),
        _mm512_permutexvar_ps(
            twice, _mm512_castps256_ps512(_mm256_loadu_ps(y))),
        _mm512_set1_ps((float)(2 * space.width)),
        _mm512_set1_ps((float)(2 * space.height)),
        {far2, far2}};
}
//<

//> Glance at two candidates
typedef __m512 see_wide_function(const struct wide_eye *eye, __m512 dx,
                                 __m512 dy);

USE_AVX512
INLINED __m512i two_from(const void *from)
{
    int64_t bits;
    memcpy(&bits, from, sizeof bits);
    return _mm512_set1_epi64(bits);
}

USE_AVX512
INLINED __m512 glance_at_two(see_wide_function *see,
                             const struct wide_eye *eye, const float *x,
                             const float *y, const uint32_t *number)
{
    enum { FIRST_WITHOUT_SECOND_OR_THIRD = 0xba };
    __m512 seen = see(
        eye,
        _mm512_sub_ps(_mm512_castsi512_ps(two_from(x)), eye->own_x),
        _mm512_sub_ps(_mm512_castsi512_ps(two_from(y)), eye->own_y));
    return _mm512_castsi512_ps(_mm512_ternarylogic_epi32(
        _mm512_castps_si512(seen), _mm512_set1_epi32(NUMBER_BITS),
        two_from(number), FIRST_WITHOUT_SECOND_OR_THIRD));
}

USE_AVX512
INLINED void glance_wide(see_wide_function *see,
                         const struct frame *frame,
                         const uint32_t *number, uint32_t begin,
                         uint32_t end, struct wide_eye *eye)
{
    for (uint32_t k = begin; k < end; k += EACH) {
        const float *x = frame->x + k, *y = frame->y + k;
        const uint32_t *here = number + k;
        for (int step = 0; step < EACH; step += 2)
            keep_wide(&eye->wide, glance_at_two(see, eye, x + step,
                                                y + step, here + step));
    }
}
//<

//> Glance at those who ask, two at a time
// Of what is seen of number k and k + 1, nobody sees himself.
USE_AVX512
INLINED __m512 nobody_self(__m512 seen, uint32_t k)
{
    __mmask16 self = (__mmask16)(9u << 2 * k); // lanes 2 k, 2 k + 3
    return _mm512_mask_mov_ps(seen, self, _mm512_set1_ps(FAR2));
}

USE_AVX512
INLINED void glance_wide_at_own(see_wide_function *see, const float *x,
                                const float *y, const uint32_t *number,
                                struct wide_eye *eye)
{
#pragma GCC unroll 4
    for (uint32_t k = 0; k < ASKING; k += 2)
        keep_wide(
            &eye->wide,
            nobody_self(
                glance_at_two(see, eye, x + k, y + k, number + k), k));
}
//<

//> Sweep with sixteen floats
USE_AVX512
INLINED void sweep_wide(see_wide_function *see, struct space space,
                        const struct sorted *sorted,
                        const struct window *window,
                        const struct tile *tile, struct sieve *sieve)
{
    const struct glance glance = point_out(sorted, window, tile);
    const struct frame *frame = window->frame;
    const uint32_t *number = window->number, own = glance.own;
    const uint32_t before = (own - glance.begin[1] + EACH - 1) / EACH;
    const float *x = frame[1].x + own, *y = frame[1].y + own;
    struct wide_eye eye = wide_eye_for(space, x, y);
    glance_wide(see, frame, number, glance.begin[0], glance.end[0],
                &eye);
    number += FRAME;
    glance_wide(see, frame + 1, number, own - before * EACH, own, &eye);
    glance_wide_at_own(see, x, y, number + own, &eye);
    glance_wide(see, frame + 1, number, own + ASKING, glance.end[1],
                &eye);
    number += FRAME;
    glance_wide(see, frame + 2, number, glance.begin[2], glance.end[2],
                &eye);
    join(&eye.wide, sieve);
}
//<
//<

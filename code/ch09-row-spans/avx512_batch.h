//> Sweep with AVX-512
// As avx2_batch.h, but two candidates at a time: lanes 2 q and 2 q + 1
// both belong to query q of the batch, and measure one candidate each.
#pragma once
#include "ch09-row-spans/avx2_certify.h"
#include <string.h>

//> Hold the state of twice the lanes
struct wide_lanes {
    __m512 x, y;
    __m512 width2, height2; // twice the box
    __m512 best, second;
};

typedef __m512 measure_wide(const struct wide_lanes *lanes, __m512 dx,
                            __m512 dy);
//<

//> Keep the best two twice
USE_AVX512
INLINED void keep_two_wide(struct wide_lanes *lanes, __m512 value)
{
    __m512 loser = _mm512_max_ps(lanes->best, value);
    lanes->best = _mm512_min_ps(lanes->best, value);
    lanes->second = _mm512_min_ps(lanes->second, loser);
}
//<

//> Join the two lanes of each query
USE_AVX512
INLINED struct best_two join_lanes(const struct wide_lanes *lanes)
{
    const __m512i even = _mm512_setr_epi32(0, 2, 4, 6, 8, 10, 12, 14, 0,
                                           2, 4, 6, 8, 10, 12, 14);
    const __m512i odd = _mm512_add_epi32(even, _mm512_set1_epi32(1));
    struct wide_lanes joined = *lanes;
    struct best_two two;
    joined.best = _mm512_permutexvar_ps(even, lanes->best);
    joined.second = _mm512_permutexvar_ps(even, lanes->second);
    keep_two_wide(&joined, _mm512_permutexvar_ps(odd, lanes->best));
    joined.second = _mm512_min_ps(
        joined.second, _mm512_permutexvar_ps(odd, lanes->second));
    _mm256_storeu_ps(two.best, _mm512_castps512_ps256(joined.best));
    _mm256_storeu_ps(two.second, _mm512_castps512_ps256(joined.second));
    return two;
}
//<

//> Show two values to eight queries
USE_AVX512
INLINED __m512i two_from(const void *from)
{
    int64_t bits;
    memcpy(&bits, from, sizeof bits);
    return _mm512_set1_epi64(bits);
}
//<

//> Measure two candidates for eight queries
USE_AVX512
INLINED __m512 measure_two(measure_wide *measure,
                           const struct wide_lanes *lanes,
                           const struct staging *staging,
                           uint32_t place)
{
    enum { FIRST_WITHOUT_SECOND_OR_THIRD = 0xba };
    __m512 x = _mm512_castsi512_ps(two_from(staging->place_x + place));
    __m512 y = _mm512_castsi512_ps(two_from(staging->place_y + place));
    __m512 value = measure(lanes, _mm512_sub_ps(x, lanes->x),
                           _mm512_sub_ps(y, lanes->y));
    return _mm512_castsi512_ps(_mm512_ternarylogic_epi32(
        _mm512_castps_si512(value), _mm512_set1_epi32(PLACE_MASK),
        two_from(staging->place + place),
        FIRST_WITHOUT_SECOND_OR_THIRD));
}
//<

//> Sweep along a span, two at a time
USE_AVX512
INLINED void sweep_span_wide(measure_wide *measure,
                             const struct staging *staging,
                             uint32_t from, uint32_t to,
                             struct wide_lanes *lanes)
{
    for (uint32_t k = from; k < to; k += STEP)
        for (uint32_t step = 0; step < STEP; step += 2)
            keep_two_wide(
                lanes, measure_two(measure, lanes, staging, k + step));
}
//<

//> Sweep over the queries themselves, two at a time
// Of candidates k and k + 1, the first is query k's own point and the
// second query k + 1's: in lanes 2 k and 2 k + 3.
USE_AVX512
INLINED void sweep_own_wide(measure_wide *measure,
                            const struct staging *staging, uint32_t own,
                            struct wide_lanes *lanes)
{
    const __m512 far2 = _mm512_set1_ps(FAR2);
#pragma GCC unroll 4
    for (uint32_t k = 0; k < BATCH; k += 2) {
        __mmask16 self = (__mmask16)(9u << 2 * k);
        __m512 value = measure_two(measure, lanes, staging, own + k);
        keep_two_wide(lanes, _mm512_mask_mov_ps(value, self, far2));
    }
}
//<

//> Sweep over three row spans with AVX-512
USE_AVX512
INLINED struct best_two sweep_wide(measure_wide *measure,
                                   const struct scene *scene,
                                   const struct staging *staging,
                                   const struct query_batch *batch)
{
    const uint32_t own = batch->own, *from = batch->from,
                   *to = batch->to;
    const uint32_t steps = (own - from[1] + STEP - 1) / STEP;
    //> Load each query into two lanes
    const __m512i twice = _mm512_setr_epi32(0, 0, 1, 1, 2, 2, 3, 3, 4,
                                            4, 5, 5, 6, 6, 7, 7);
    const __m256 x = _mm256_loadu_ps(staging->place_x + own);
    const __m256 y = _mm256_loadu_ps(staging->place_y + own);
    const __m512 far2 = _mm512_set1_ps(FAR2);
    struct wide_lanes lanes = {
        _mm512_permutexvar_ps(twice, _mm512_castps256_ps512(x)),
        _mm512_permutexvar_ps(twice, _mm512_castps256_ps512(y)),
        _mm512_set1_ps((float)(2 * scene->space.width)),
        _mm512_set1_ps((float)(2 * scene->space.height)),
        far2,
        far2};
    //<
    sweep_span_wide(measure, staging, from[0], to[0], &lanes);
    sweep_span_wide(measure, staging, own - steps * STEP, own, &lanes);
    sweep_own_wide(measure, staging, own, &lanes);
    sweep_span_wide(measure, staging, own + BATCH, to[1], &lanes);
    sweep_span_wide(measure, staging, from[2], to[2], &lanes);
    return join_lanes(&lanes);
}
//<
//<

//> Sweep with AVX2
// As portable_batch.h, with eight floats or four doubles at a time. A
// span is swept in steps of STEP: what the last step meets beyond its
// end is another candidate, or FAR.
#pragma once
#include "ch09-row-spans/batch.h"
#include "common/isa.h"
#include <immintrin.h>

//> Hold the state of the lanes
struct lane_state {
    __m256 x, y;            // the queries
    __m256 width2, height2; // twice the box
    __m256 best, second;
};

// What is compared: the less, the better.
typedef __m256 measure_lanes(const struct lane_state *lanes, __m256 dx,
                             __m256 dy);
//<

//> Keep the best two
USE_AVX2
INLINED void keep_two(struct lane_state *lanes, __m256 value)
{
    __m256 loser = _mm256_max_ps(lanes->best, value);
    lanes->best = _mm256_min_ps(lanes->best, value);
    lanes->second = _mm256_min_ps(lanes->second, loser);
}
//<

//> Measure one candidate for eight queries
// The low bits of what comes out make room for the candidate's place.
USE_AVX2
INLINED __m256 measure_one(measure_lanes *measure,
                           const struct lane_state *lanes,
                           const struct staging *staging,
                           uint32_t place)
{
    const float *x = staging->place_x + place;
    const float *y = staging->place_y + place;
    __m256 value =
        measure(lanes, _mm256_sub_ps(_mm256_broadcast_ss(x), lanes->x),
                _mm256_sub_ps(_mm256_broadcast_ss(y), lanes->y));
    return _mm256_castsi256_ps(_mm256_blendv_epi8(
        _mm256_castps_si256(value),
        _mm256_set1_epi32((int)staging->place[place]),
        _mm256_set1_epi32(PLACE_MASK)));
}
//<

//> Sweep along a span
USE_AVX2
INLINED void sweep_span(measure_lanes *measure,
                        const struct staging *staging, uint32_t from,
                        uint32_t to, struct lane_state *lanes)
{
    for (uint32_t k = from; k < to; k += STEP) {
#pragma GCC unroll 4
        for (uint32_t step = 0; step < STEP; step++)
            keep_two(lanes,
                     measure_one(measure, lanes, staging, k + step));
    }
}
//<

//> Sweep over the queries themselves
// No query is its own candidate.
USE_AVX2
INLINED void sweep_own(measure_lanes *measure,
                       const struct staging *staging, uint32_t own,
                       struct lane_state *lanes)
{
    const __m256 far2 = _mm256_set1_ps(FAR2);
    const __m256i lane = _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7);
#pragma GCC unroll 8
    for (int k = 0; k < BATCH; k++) {
        __m256i self = _mm256_cmpeq_epi32(lane, _mm256_set1_epi32(k));
        __m256 value = measure_one(measure, lanes, staging, own + k);
        keep_two(lanes, _mm256_blendv_ps(value, far2,
                                         _mm256_castsi256_ps(self)));
    }
}
//<

//> Sweep over three row spans with AVX2
// In the middle row in steps back from the queries, and on from them.
USE_AVX2
INLINED struct best_two sweep(measure_lanes *measure,
                              const struct scene *scene,
                              const struct staging *staging,
                              const struct query_batch *batch)
{
    const uint32_t own = batch->own, *from = batch->from,
                   *to = batch->to;
    const uint32_t steps = (own - from[1] + STEP - 1) / STEP;
    const __m256 far2 = _mm256_set1_ps(FAR2);
    struct lane_state lanes = {
        _mm256_loadu_ps(staging->place_x + own),
        _mm256_loadu_ps(staging->place_y + own),
        _mm256_set1_ps((float)(2 * scene->space.width)),
        _mm256_set1_ps((float)(2 * scene->space.height)),
        far2,
        far2};
    struct best_two two;
    sweep_span(measure, staging, from[0], to[0], &lanes);
    sweep_span(measure, staging, own - steps * STEP, own, &lanes);
    sweep_own(measure, staging, own, &lanes);
    sweep_span(measure, staging, own + BATCH, to[1], &lanes);
    sweep_span(measure, staging, from[2], to[2], &lanes);
    _mm256_storeu_ps(two.best, lanes.best);
    _mm256_storeu_ps(two.second, lanes.second);
    return two;
}
//<
//<

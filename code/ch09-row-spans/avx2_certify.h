//> Certify with AVX2
// What follows a sweep, for eight lanes at once: the places of the best
// become candidates, these get their distances in double precision, and
// a lane is certified if no other point can compete with its candidate.
// How four candidates are verified is a parameter: chapter 10 verifies
// that they are the furthest.
#pragma once
#include "ch08-vector-spiral/near2.h"
#include "ch09-row-spans/avx2_batch.h"

//> Find four margins
// As range_margin has them.
USE_AVX2
INLINED __m256d four_margins(const enum geometry geometry,
                             const struct axis *axis,
                             const struct axis_range *range, __m256d x)
{
    __m256d direct = _mm256_min_pd(
        _mm256_sub_pd(x, _mm256_set1_pd(range->below.high)),
        _mm256_sub_pd(_mm256_set1_pd(range->above.low), x));
    if (geometry == STANDARD)
        return direct;
    __m256d furthest = _mm256_max_pd(
        _mm256_sub_pd(x, _mm256_set1_pd(range->below.low)),
        _mm256_sub_pd(_mm256_set1_pd(range->above.high), x));
    return _mm256_min_pd(
        direct, _mm256_sub_pd(_mm256_set1_pd(axis->period), furthest));
}
//<

//> Hold four queries
// Four queries, and how far away their best candidates are.
struct four {
    __m256d x, y, dx, dy;
};

// Computes four squared distances in double precision, and returns four
// bits: that nothing outside of the block can compete.
typedef uint32_t verify_function(const enum geometry geometry,
                                 const struct scene *scene,
                                 const struct block *block,
                                 const struct four *four, double d2[4]);
//<

//> Verify four candidates
USE_AVX2
INLINED uint32_t verify_four(verify_function *verify,
                             const enum geometry geometry,
                             const struct scene *scene,
                             const struct query_batch *batch, int first,
                             struct batch_result *result)
{
    const struct points p = scene->sorted->points;
    const double *x = p.x, *y = p.y;
    const uint32_t *t = result->candidate + first;
    const uint32_t at = batch->begin + first;
    struct four four = {
        _mm256_loadu_pd(x + at), _mm256_loadu_pd(y + at),
        _mm256_setr_pd(x[t[0]], x[t[1]], x[t[2]], x[t[3]]),
        _mm256_setr_pd(y[t[0]], y[t[1]], y[t[2]], y[t[3]])};
    four.dx = _mm256_sub_pd(four.dx, four.x);
    four.dy = _mm256_sub_pd(four.dy, four.y);
    return verify(geometry, scene, &batch->block, &four,
                  result->distance2 + first);
}
//<

//> Find eight certain lanes
// Where the second is clearly worse than the best.
USE_AVX2
INLINED uint32_t certain_lanes(const struct best_two *two, float slack)
{
    __m256 best = _mm256_loadu_ps(two->best);
    __m256 bound = _mm256_add_ps(
        _mm256_mul_ps(best, _mm256_set1_ps(1 + RELATIVE_SLACK)),
        _mm256_set1_ps(slack));
    return (uint32_t)_mm256_movemask_ps(
        _mm256_cmp_ps(_mm256_loadu_ps(two->second), bound, _CMP_GT_OQ));
}
//<

//> Look up eight candidates
USE_AVX2
INLINED void look_up(const struct staging *staging,
                     const struct best_two *two,
                     struct batch_result *result)
{
    uint32_t place[BATCH];
    __m256i bits = _mm256_castps_si256(_mm256_loadu_ps(two->best));
    _mm256_storeu_si256(
        (__m256i *)place,
        _mm256_and_si256(bits, _mm256_set1_epi32(PLACE_MASK)));
    for (int lane = 0; lane < BATCH; lane++)
        result->candidate[lane] = staging->index[place[lane]];
}
//<

//> Certify eight with AVX2
// The candidates get their distances, and a lane is certified if no
// other point can compete, in the block or beyond.
USE_AVX2
INLINED uint32_t certify(const enum geometry geometry,
                         verify_function *verify,
                         const struct scene *scene,
                         const struct query_batch *batch,
                         uint32_t certain, struct batch_result *result)
{
    uint32_t low =
        verify_four(verify, geometry, scene, batch, 0, result);
    uint32_t high =
        verify_four(verify, geometry, scene, batch, 4, result);
    return certain & (low | high << 4);
}
//<

//> Verify four nearest
USE_AVX2
INLINED uint32_t verify_near(const enum geometry geometry,
                             const struct scene *scene,
                             const struct block *block,
                             const struct four *four, double near2[4])
{
    const struct grid *grid = &scene->sorted->grid;
    __m256d d2 = four_near2(geometry, scene->space, four->dx, four->dy);
    __m256d margin = _mm256_min_pd(
        four_margins(geometry, &grid->x, &block->x, four->x),
        four_margins(geometry, &grid->y, &block->y, four->y));
    _mm256_storeu_pd(near2, d2);
    return (uint32_t)_mm256_movemask_pd(
        _mm256_cmp_pd(d2, _mm256_mul_pd(margin, margin), _CMP_LT_OQ));
}
//<

//> Certify eight nearest
USE_AVX2
INLINED uint32_t certify_near(const struct scene *scene,
                              const struct staging *staging,
                              const struct query_batch *batch,
                              const struct best_two *two,
                              struct batch_result *result)
{
    const uint32_t certain = certain_lanes(two, near_slack(staging));
    look_up(staging, two, result);
    return IN_GEOMETRY(scene->space, certify, verify_near, scene, batch,
                       certain, result);
}
//<
//<

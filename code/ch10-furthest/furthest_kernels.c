//> Find the furthest of a batch
// If a pair is separated by a and b in a box of w by h, its furthest
// images lack a (2 w - a) + b (2 h - b) of the largest squared distance
// there is. We call that their loss; the furthest point has the least,
// and the filter of chapter 9 finds the least, with as many candidates
// as for the nearest.
#include "ch10-furthest/furthest_kernels.h"
#include "ch09-row-spans/portable_batch.h"
#ifdef HAVE_X86_VECTORS
#include "ch09-row-spans/avx512_batch.h"
#endif

//> Know how far a loss can be off
// Staging and subtracting leaves a separation off by less than 5 *
// 2^-24 of the reach, which the loss multiplies by less than 2 w or 2
// h; all else is relative, and mostly the place in the low bits. A
// squared distance in double precision is off by less than 7 * 2^-53 of
// the largest. Two losses are compared, and 2^-12 of the lesser
// besides.
static inline float loss_slack(struct space space, double reach)
{
    return (float)((space.width + space.height) * reach * 0x1p-19 +
                   (space.width * space.width +
                    space.height * space.height) *
                       0x1p-48);
}
//<

//> Measure a loss
// What is at FAR must not seem to be near: its loss is huge, but less
// than 0.
INLINED float measure_loss(const struct scene *scene, float dx,
                           float dy)
{
    const float width2 = (float)(2 * scene->space.width);
    const float height2 = (float)(2 * scene->space.height);
    dx = fabsf(dx), dy = fabsf(dy);
    return fabsf(dx * (width2 - dx) + dy * (height2 - dy));
}
//<

//> Find the furthest in plain C
uint32_t portable_furthest(const struct scene *scene,
                           const struct staging *staging,
                           const struct query_batch *batch,
                           struct batch_result *result)
{
    const struct sorted *sorted = scene->sorted;
    const double *x = sorted->points.x, *y = sorted->points.y;
    const struct space space = scene->space;
    const struct best_two two =
        sweep_plainly(measure_loss, scene, staging, batch);
    const float slack = loss_slack(space, staging->reach);
    uint32_t certified = 0;
    for (int lane = 0; lane < BATCH; lane++) {
        //> Certify a lane for the furthest
        uint32_t s = batch->begin + lane;
        uint32_t t = staging->index[place_of(two.best[lane])];
        double far2 =
            pair2(WRAPAROUND, space, x[t] - x[s], y[t] - y[s]).far2;
        result->candidate[lane] = t;
        result->distance2[lane] = far2;
        certified |= (uint32_t)(is_certain(&two, lane, slack) &&
                                far2 > furthest_outside2(
                                           &sorted->grid, &batch->block,
                                           space, x[s], y[s]))
                     << lane;
        //<
    }
    return certified;
}
//<

#ifdef HAVE_X86_VECTORS
//> Measure losses with AVX2
USE_AVX2
INLINED __m256 measure_losses(const struct lane_state *lanes, __m256 dx,
                              __m256 dy)
{
    const __m256 sign = _mm256_set1_ps(-0.0F);
    dx = _mm256_andnot_ps(sign, dx);
    dy = _mm256_andnot_ps(sign, dy);
    __m256 loss = _mm256_fmadd_ps(
        dx, _mm256_sub_ps(lanes->width2, dx),
        _mm256_mul_ps(dy, _mm256_sub_ps(lanes->height2, dy)));
    return _mm256_andnot_ps(sign, loss);
}
//<

//> Verify four furthest
// As pair2 and furthest_outside2 have it.
USE_AVX2
INLINED __m256d larger_way(double period, __m256d d)
{
    d = _mm256_andnot_pd(_mm256_set1_pd(-0.0), d);
    return _mm256_max_pd(d, _mm256_sub_pd(_mm256_set1_pd(period), d));
}

USE_AVX2
INLINED __m256d sum_of_squares(__m256d a, __m256d b)
{
    return _mm256_add_pd(_mm256_mul_pd(a, a), _mm256_mul_pd(b, b));
}

USE_AVX2
INLINED uint32_t verify_far(const enum geometry geometry,
                            const struct scene *scene,
                            const struct block *block,
                            const struct four *four, double far2[4])
{
    const struct grid *grid = &scene->sorted->grid;
    const struct space space = scene->space;
    const __m256d w = _mm256_set1_pd(space.width);
    const __m256d h = _mm256_set1_pd(space.height);
    __m256d d2 = sum_of_squares(larger_way(space.width, four->dx),
                                larger_way(space.height, four->dy));
    __m256d across = _mm256_sub_pd(
        w, four_margins(geometry, &grid->x, &block->x, four->x));
    __m256d up = _mm256_sub_pd(
        h, four_margins(geometry, &grid->y, &block->y, four->y));
    __m256d outside2 = _mm256_mul_pd(
        _mm256_max_pd(sum_of_squares(across, h), sum_of_squares(w, up)),
        _mm256_set1_pd(ROUNDING_GUARD));
    _mm256_storeu_pd(far2, d2);
    return (uint32_t)_mm256_movemask_pd(
        _mm256_cmp_pd(d2, outside2, _CMP_GT_OQ));
}
//<

//> Certify the lanes that are certain
USE_AVX2
INLINED uint32_t certify_far(const struct scene *scene,
                             const struct staging *staging,
                             const struct query_batch *batch,
                             const struct best_two *two,
                             struct batch_result *result)
{
    const float slack = loss_slack(scene->space, staging->reach);
    const uint32_t certain = certain_lanes(two, slack);
    look_up(staging, two, result);
    return certify(WRAPAROUND, verify_far, scene, batch, certain,
                   result);
}
//<

//> Find the furthest with AVX2
USE_AVX2
uint32_t avx2_furthest(const struct scene *scene,
                       const struct staging *staging,
                       const struct query_batch *batch,
                       struct batch_result *result)
{
    struct best_two two = sweep(measure_losses, scene, staging, batch);
    return certify_far(scene, staging, batch, &two, result);
}
//<

//> Find the furthest with AVX-512
// Only the sweep is another one.
USE_AVX512
INLINED __m512 measure_losses_wide(const struct wide_lanes *lanes,
                                   __m512 dx, __m512 dy)
{
    dx = _mm512_abs_ps(dx);
    dy = _mm512_abs_ps(dy);
    return _mm512_abs_ps(_mm512_fmadd_ps(
        dx, _mm512_sub_ps(lanes->width2, dx),
        _mm512_mul_ps(dy, _mm512_sub_ps(lanes->height2, dy))));
}

USE_AVX512
uint32_t avx512_furthest(const struct scene *scene,
                         const struct staging *staging,
                         const struct query_batch *batch,
                         struct batch_result *result)
{
    struct best_two two =
        sweep_wide(measure_losses_wide, scene, staging, batch);
    return certify_far(scene, staging, batch, &two, result);
}
//<
#endif

batch_kernel *furthest_kernel(void)
{
    static batch_kernel *const kernels[ISA_COUNT] =
        FOR_EACH_ISA(portable_furthest, avx2_furthest, avx512_furthest);
    return kernels[isa_chosen()];
}
//<

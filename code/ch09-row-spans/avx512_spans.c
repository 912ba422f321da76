//> Search row spans with AVX-512
// The kernels of span_kernels.h, sixteen floats or eight doubles at a
// time: a step of the sweep compares two candidates with eight queries.
// What follows the sweep is AVX2's.
#include "ch09-row-spans/span_kernels.h"
#ifdef HAVE_X86_VECTORS
#include "ch09-row-spans/avx512_batch.h"

//> Stage eight with a mask
USE_AVX512
static void stage(const struct sorted *sorted,
                  const struct span_source *source, uint32_t place,
                  struct staging *staging)
{
    const struct points p = sorted->points;
    const __m512d x = _mm512_set1_pd(source->x),
                  y = _mm512_set1_pd(source->y);
    const __m256i lane = _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7);
    uint32_t k = place;
    for (uint64_t s = source->begin; s < source->end; s += 8, k += 8) {
        uint32_t left = source->end - s;
        __mmask8 there = (__mmask8)(left < 8 ? (1u << left) - 1 : 255);
        __m512d dx =
            _mm512_sub_pd(_mm512_maskz_loadu_pd(there, p.x + s), x);
        __m512d dy =
            _mm512_sub_pd(_mm512_maskz_loadu_pd(there, p.y + s), y);
        __m256i index =
            _mm256_add_epi32(_mm256_set1_epi32((int)s), lane);
        _mm256_storeu_ps(staging->place_x + k, _mm512_cvtpd_ps(dx));
        _mm256_storeu_ps(staging->place_y + k, _mm512_cvtpd_ps(dy));
        _mm256_storeu_si256((__m256i *)(staging->index + k), index);
    }
}
//<

//> Find the nearest of a batch with AVX-512
USE_AVX512
INLINED __m512 measure_near(const struct wide_lanes *lanes, __m512 dx,
                            __m512 dy)
{
    (void)lanes;
    return _mm512_fmadd_ps(dx, dx, _mm512_mul_ps(dy, dy));
}

USE_AVX512
static uint32_t nearest(const struct scene *scene,
                        const struct staging *staging,
                        const struct query_batch *batch,
                        struct batch_result *result)
{
    struct best_two two =
        sweep_wide(measure_near, scene, staging, batch);
    return certify_near(scene, staging, batch, &two, result);
}
//<

//> Compare with eight points at a time
//> Hold the best of eight lanes
struct eight_best {
    __m512d best2;
    __m512i nearest, self;
};
//<

//> Keep the best of eight lanes
USE_AVX512
INLINED void keep_eight(struct eight_best *eight, __m512d d2,
                        __m512i candidate, __mmask8 there)
{
    __mmask8 less = _mm512_cmp_pd_mask(d2, eight->best2, _CMP_LT_OQ);
    __mmask8 same = _mm512_cmp_pd_mask(d2, eight->best2, _CMP_EQ_OQ);
    __mmask8 first = _mm512_cmpgt_epi64_mask(eight->nearest, candidate);
    __mmask8 self = _mm512_cmpeq_epi64_mask(candidate, eight->self);
    __mmask8 better =
        (__mmask8)((less | (same & first)) & ~self & there);
    eight->best2 = _mm512_mask_mov_pd(eight->best2, better, d2);
    eight->nearest =
        _mm512_mask_mov_epi64(eight->nearest, better, candidate);
}
//<

//> Compare a query with a row span, eight at a time
USE_AVX512
INLINED void compare_span(const enum geometry geometry,
                          const struct scene *scene, uint32_t begin,
                          uint32_t end, struct query *query)
{
    const struct points p = scene->sorted->points;
    const uint32_t *point = scene->sorted->cells.point;
    const __m512d x = _mm512_set1_pd(query->x);
    const __m512d y = _mm512_set1_pd(query->y);
    struct eight_best eight = {_mm512_set1_pd(query->best2),
                               _mm512_set1_epi64(query->nearest),
                               _mm512_set1_epi64(query->self)};
    for (uint64_t s = begin; s < end; s += 8) {
        uint32_t left = end - s;
        __mmask8 there = (__mmask8)(left < 8 ? (1u << left) - 1 : 255);
        __m512d d2 = eight_near2(
            geometry, scene->space,
            _mm512_sub_pd(_mm512_maskz_loadu_pd(there, p.x + s), x),
            _mm512_sub_pd(_mm512_maskz_loadu_pd(there, p.y + s), y));
        __m256i candidate = _mm256_maskz_loadu_epi32(there, point + s);
        keep_eight(&eight, d2, _mm512_cvtepu32_epi64(candidate), there);
    }
    //> Compare the eight lanes
    double best2[8];
    uint64_t nearest[8];
    _mm512_storeu_pd(best2, eight.best2);
    _mm512_storeu_si512(nearest, eight.nearest);
    for (int lane = 0; lane < 8; lane++)
        query_keep(query, (uint32_t)nearest[lane], best2[lane]);
    //<
}
//<

USE_AVX512
static void compare_with_span(const struct scene *scene, uint32_t begin,
                              uint32_t end, struct query *query)
{
    IN_GEOMETRY(scene->space, compare_span, scene, begin, end, query);
}
//<

const struct span_kernels avx512_spans = {"avx512", stage, nearest,
                                          compare_with_span};
#endif
//<

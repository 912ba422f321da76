//> Search row spans with AVX2
// The kernels of span_kernels.h, eight floats or four doubles at a
// time: some twelve instructions for a candidate and eight queries.
#include "ch09-row-spans/span_kernels.h"
#ifdef HAVE_X86_VECTORS
#include "ch09-row-spans/avx2_certify.h"

//> Take eight coordinates
USE_AVX2
INLINED __m256 eight_from(const double *x, __m256d origin)
{
    __m256d low = _mm256_sub_pd(_mm256_loadu_pd(x), origin);
    __m256d high = _mm256_sub_pd(_mm256_loadu_pd(x + 4), origin);
    return _mm256_set_m128(_mm256_cvtpd_ps(high), _mm256_cvtpd_ps(low));
}
//<

//> Stage eight at a time
// As long as there are eight in memory.
USE_AVX2
static void stage(const struct sorted *sorted,
                  const struct span_source *source, uint32_t place,
                  struct staging *staging)
{
    const struct points p = sorted->points;
    const __m256d x = _mm256_set1_pd(source->x),
                  y = _mm256_set1_pd(source->y);
    const __m256i lane = _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7);
    uint32_t s = source->begin, k = place;
    for (; s < source->end && p.n - s >= 8; s += 8, k += 8) {
        __m256i index =
            _mm256_add_epi32(_mm256_set1_epi32((int)s), lane);
        _mm256_storeu_ps(staging->place_x + k, eight_from(p.x + s, x));
        _mm256_storeu_ps(staging->place_y + k, eight_from(p.y + s, y));
        _mm256_storeu_si256((__m256i *)(staging->index + k), index);
    }
    for (; s < source->end; s++, k++) {
        staging->place_x[k] = (float)(p.x[s] - source->x);
        staging->place_y[k] = (float)(p.y[s] - source->y);
        staging->index[k] = s;
    }
}
//<

//> Find the nearest of a batch with AVX2
USE_AVX2
INLINED __m256 measure_near(const struct lane_state *lanes, __m256 dx,
                            __m256 dy)
{
    (void)lanes;
    return _mm256_fmadd_ps(dx, dx, _mm256_mul_ps(dy, dy));
}

USE_AVX2
static uint32_t nearest(const struct scene *scene,
                        const struct staging *staging,
                        const struct query_batch *batch,
                        struct batch_result *result)
{
    struct best_two two = sweep(measure_near, scene, staging, batch);
    return certify_near(scene, staging, batch, &two, result);
}
//<

//> Compare with four points at a time
//> Hold the best of four lanes
// A lane's best and its index stay in registers.
struct four_best {
    __m256d best2;
    __m256i nearest, self;
};
//<

//> Keep best and index in registers
USE_AVX2
INLINED void keep_four(struct four_best *four, __m256d d2,
                       __m256i candidate, __m256i there)
{
    __m256d less = _mm256_cmp_pd(d2, four->best2, _CMP_LT_OQ);
    __m256d same = _mm256_cmp_pd(d2, four->best2, _CMP_EQ_OQ);
    __m256d first = _mm256_castsi256_pd(
        _mm256_cmpgt_epi64(four->nearest, candidate));
    __m256i better = _mm256_castpd_si256(
        _mm256_or_pd(less, _mm256_and_pd(same, first)));
    better =
        _mm256_andnot_si256(_mm256_cmpeq_epi64(candidate, four->self),
                            _mm256_and_si256(better, there));
    four->best2 =
        _mm256_blendv_pd(four->best2, d2, _mm256_castsi256_pd(better));
    four->nearest =
        _mm256_blendv_epi8(four->nearest, candidate, better);
}
//<

//> Compare a query with a row span, four at a time
USE_AVX2
INLINED void compare_span(const enum geometry geometry,
                          const struct scene *scene, uint32_t begin,
                          uint32_t end, struct query *query)
{
    const struct points p = scene->sorted->points;
    const int *point = (const int *)scene->sorted->cells.point;
    const __m256d x = _mm256_set1_pd(query->x);
    const __m256d y = _mm256_set1_pd(query->y);
    const __m128i lane = _mm_setr_epi32(0, 1, 2, 3);
    struct four_best four = {_mm256_set1_pd(query->best2),
                             _mm256_set1_epi64x(query->nearest),
                             _mm256_set1_epi64x(query->self)};
    for (uint64_t s = begin; s < end; s += 4) {
        int left = (int)(end - s < 4 ? end - s : 4);
        __m128i there = _mm_cmpgt_epi32(_mm_set1_epi32(left), lane);
        __m256i wide = _mm256_cvtepi32_epi64(there);
        __m256d d2 = four_near2(
            geometry, scene->space,
            _mm256_sub_pd(_mm256_maskload_pd(p.x + s, wide), x),
            _mm256_sub_pd(_mm256_maskload_pd(p.y + s, wide), y));
        __m128i candidate = _mm_maskload_epi32(point + s, there);
        keep_four(&four, d2, _mm256_cvtepu32_epi64(candidate), wide);
    }
    double best2[4];
    uint64_t nearest[4];
    _mm256_storeu_pd(best2, four.best2);
    _mm256_storeu_si256((__m256i *)nearest, four.nearest);
    for (int lane = 0; lane < 4; lane++)
        query_keep(query, (uint32_t)nearest[lane], best2[lane]);
}
//<

USE_AVX2
static void compare_with_span(const struct scene *scene, uint32_t begin,
                              uint32_t end, struct query *query)
{
    IN_GEOMETRY(scene->space, compare_span, scene, begin, end, query);
}
//<

const struct span_kernels avx2_spans = {"avx2", stage, nearest,
                                        compare_with_span};
#endif
//<

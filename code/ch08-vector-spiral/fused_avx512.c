//> Fuse the loops in AVX-512
// Both kernels of spiral_kernels.h, each a single pass over its list,
// eight tasks or visits at a time. Every load, store, gather and
// scatter has a mask of the lanes that it is for, so that a vector need
// not be full.
#include "ch08-vector-spiral/spiral_kernels.h"
#ifdef HAVE_X86_VECTORS
#include "ch08-vector-spiral/near2.h"
#include <immintrin.h>
#include <stdlib.h>

//> Mask the lanes that are left
USE_AVX512
static inline __mmask8 left(uint32_t n)
{
    return n < 8 ? (__mmask8)((1u << n) - 1) : 0xff;
}

USE_AVX512
static inline __m256i eight(__mmask8 marked, const void *from)
{
    return _mm256_maskz_loadu_epi32(marked, from);
}
//<

//> Compress, then store
// The marked visits, behind the k that are already kept. Compress in a
// register: straight to memory is slow on some processors.
USE_AVX512
static inline uint32_t keep_visits(const struct visits *here,
                                   uint32_t k, __mmask8 lanes,
                                   __m256i task, __m256i at,
                                   __m256i end)
{
    _mm256_storeu_si256((__m256i *)(here->task + k),
                        _mm256_maskz_compress_epi32(lanes, task));
    _mm256_storeu_si256((__m256i *)(here->at + k),
                        _mm256_maskz_compress_epi32(lanes, at));
    _mm256_storeu_si256((__m256i *)(here->end + k),
                        _mm256_maskz_compress_epi32(lanes, end));
    return k + (uint32_t)__builtin_popcount(lanes);
}
//<

//> Take eight tasks along an axis
USE_AVX512
INLINED __m256i cells_after(const enum geometry geometry,
                            const struct axis *axis, __m256i cell,
                            int32_t by)
{
    __m256i to = _mm256_add_epi32(cell, _mm256_set1_epi32(by));
    if (geometry == STANDARD)
        return to;
    //> Begin anew past an end, in eight lanes
    const __m256i m = _mm256_set1_epi32((int32_t)axis->count);
    __mmask8 below =
        _mm256_mask_cmpge_epi32_mask(0xff, _mm256_set1_epi32(-1), to);
    __mmask8 beyond = _mm256_mask_cmpge_epi32_mask(0xff, to, m);
    to = _mm256_mask_add_epi32(to, below, to, m);
    return _mm256_mask_add_epi32(
        to, beyond, to, _mm256_sub_epi32(_mm256_setzero_si256(), m));
    //<
}
//<

//> Mark the lanes within the bounds
USE_AVX512
static inline __mmask8 at_least(__mmask8 marked, const int32_t *bound,
                                __m256i steps)
{
    return _mm256_mask_cmpge_epi32_mask(marked, eight(marked, bound),
                                        steps);
}
//<

//> Enter a cell, eight by eight
USE_AVX512
INLINED void enter_in(const enum geometry geometry,
                      const struct map *map, struct strip *strip,
                      const struct tasks *tasks, int32_t dx, int32_t dy)
{
    const struct axis *x = &map->grid->x, *y = &map->grid->y;
    const __m256i columns = _mm256_set1_epi32((int32_t)x->count);
    const __m256i steps_x = _mm256_set1_epi32(abs(dx));
    const __m256i steps_y = _mm256_set1_epi32(abs(dy));
    const int32_t *bound_x = tasks->bound[dx < 0 ? WEST : EAST];
    const int32_t *bound_y = tasks->bound[dy < 0 ? SOUTH : NORTH];
    uint32_t n = tasks->n, k = 0;
    uint64_t visited = 0;
    for (uint32_t i = 0; i < n; i += 8) {
        __mmask8 within = at_least(left(n - i), bound_x + i, steps_x);
        within = at_least(within, bound_y + i, steps_y);
        //> Number the cells of the marked lanes
        __m256i row =
            cells_after(geometry, y, eight(within, tasks->row + i), dy);
        __m256i cell = _mm256_add_epi32(
            _mm256_mullo_epi32(row, columns),
            cells_after(geometry, x, eight(within, tasks->column + i),
                        dx));
        //<
        //> Gather where each cell begins and ends
        __m512i two = _mm512_mask_i64gather_epi64(
            _mm512_setzero_si512(), within, _mm512_cvtepu32_epi64(cell),
            map->cells->start, 4);
        __m256i begin = _mm512_cvtepi64_epi32(two);
        __m256i end = _mm512_cvtepi64_epi32(_mm512_srli_epi64(two, 32));
        //<
        visited += (unsigned)__builtin_popcount(within);
        k = keep_visits(
            &strip->here, k,
            _mm256_mask_cmpneq_epi32_mask(within, begin, end),
            eight(within, tasks->task + i), begin, end);
    }
    strip->tally.visited += visited;
    strip->here.n = k;
}
//<

//> Gather in the marked lanes
USE_AVX512
static inline __m512d doubles(__mmask8 marked, __m512i index,
                              const double *from)
{
    return _mm512_mask_i64gather_pd(_mm512_setzero_pd(), marked, index,
                                    from, 8);
}

USE_AVX512
static inline __m256i numbers(__mmask8 marked, __m512i index,
                              const uint32_t *from)
{
    return _mm512_mask_i64gather_epi32(_mm256_setzero_si256(), marked,
                                       index, from, 4);
}
//<

//> Compare eight points
USE_AVX512
INLINED void compare_eight(const enum geometry geometry,
                           const struct map *map, struct strip *strip,
                           __mmask8 marked, __m256i task, __m256i at)
{
    const struct points p = map->points;
    __m256i point =
        numbers(marked, _mm512_cvtepu32_epi64(at), map->cells->point);
    __m512i t = _mm512_cvtepu32_epi64(task);
    __m512i j = _mm512_cvtepu32_epi64(point);
    __m512d d2 =
        eight_near2(geometry, map->space,
                    _mm512_sub_pd(doubles(marked, j, p.x),
                                  doubles(marked, t, strip->x)),
                    _mm512_sub_pd(doubles(marked, j, p.y),
                                  doubles(marked, t, strip->y)));
    __m512d best2 = doubles(marked, t, strip->best2);
    __m256i nearest = numbers(marked, t, strip->nearest);
    //> Keep what is nearer, by masks
    __m256i own = _mm256_add_epi32(
        task, _mm256_set1_epi32((int32_t)strip->first));
    __mmask8 others = _mm256_mask_cmpneq_epi32_mask(marked, at, own);
    __mmask8 nearer = _mm512_mask_cmplt_pd_mask(others, d2, best2);
    __mmask8 tie = _mm512_mask_cmpeq_pd_mask(others, d2, best2);
    tie = _mm256_mask_cmple_epu32_mask(tie, point, nearest);
    __mmask8 better = nearer | tie;
    _mm512_mask_i64scatter_pd(strip->best2, better, t, d2, 8);
    _mm512_mask_i64scatter_epi32(strip->nearest, better, t, point, 4);
    //<
}
//<

//> Compare all visits, by masks
USE_AVX512
INLINED void compare_in(const enum geometry geometry,
                        const struct map *map, struct strip *strip)
{
    const struct visits *here = &strip->here;
    const __m256i one = _mm256_set1_epi32(1);
    uint32_t n = here->n, k = 0;
    for (uint32_t i = 0; i < n; i += 8) {
        __mmask8 all = left(n - i);
        __m256i task = eight(all, here->task + i);
        __m256i at = eight(all, here->at + i);
        __m256i end = eight(all, here->end + i);
        compare_eight(geometry, map, strip, all, task, at);
        at = _mm256_add_epi32(at, one);
        k = keep_visits(here, k,
                        _mm256_mask_cmpneq_epi32_mask(all, at, end),
                        task, at, end);
    }
    strip->here.n = k;
}
//<

#define TARGET USE_AVX512
#include "ch08-vector-spiral/both_geometries.h"

const struct spiral_kernels avx512_spiral = {AVX512, enter_cells,
                                             compare_points};
#endif
//<

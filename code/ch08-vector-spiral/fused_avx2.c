//> Fuse the loops in AVX2
// Both kernels of spiral_kernels.h, each a single pass over its list,
// eight tasks or visits at a time; doubles in two halves. Gathers and
// scatters are loads and stores for each lane, as in chapter 6.
#include "ch08-vector-spiral/spiral_kernels.h"
#ifdef HAVE_X86_VECTORS
#include "ch08-vector-spiral/lanes_avx2.h"
#include "ch08-vector-spiral/near2.h"
#include <stdlib.h>

//> Pack visits in registers
// Those lanes of a vector of visits whose bit is set, behind the k that
// are already kept. Returns how many there are then.
USE_AVX2
static inline uint32_t keep_visits(const struct visits *here,
                                   uint32_t k, unsigned lanes,
                                   __m256i task, __m256i at,
                                   __m256i end)
{
    uint64_t bytes = _pdep_u64(lanes, 0x0101010101010101) * 0xff;
    uint64_t kept = _pext_u64(0x0706050403020100, bytes);
    __m256i order =
        _mm256_cvtepu8_epi32(_mm_cvtsi64_si128((long long)kept));
    put(here->task + k, _mm256_permutevar8x32_epi32(task, order));
    put(here->at + k, _mm256_permutevar8x32_epi32(at, order));
    put(here->end + k, _mm256_permutevar8x32_epi32(end, order));
    return k + (uint32_t)__builtin_popcount(lanes);
}

USE_AVX2
static inline unsigned bits(__m256i lanes)
{
    return (unsigned)_mm256_movemask_ps(_mm256_castsi256_ps(lanes));
}
//<

//> Load the bounds of eight cells
// A cell begins where its number says, and ends where the next begins:
// two numbers in one load.
USE_AVX2
static inline __m256i four_bounds(const uint32_t *start,
                                  const uint32_t *cell)
{
    __m128i a = _mm_loadl_epi64((const __m128i *)(start + cell[0]));
    __m128i b = _mm_loadl_epi64((const __m128i *)(start + cell[1]));
    __m128i c = _mm_loadl_epi64((const __m128i *)(start + cell[4]));
    __m128i d = _mm_loadl_epi64((const __m128i *)(start + cell[5]));
    return _mm256_inserti128_si256(
        _mm256_castsi128_si256(_mm_unpacklo_epi64(a, b)),
        _mm_unpacklo_epi64(c, d), 1);
}

USE_AVX2
static inline void bounds(const uint32_t *start, __m256i cells,
                          __m256i *begin, __m256i *end)
{
    uint32_t cell[8];
    put(cell, cells);
    __m256 low = _mm256_castsi256_ps(four_bounds(start, cell));
    __m256 high = _mm256_castsi256_ps(four_bounds(start, cell + 2));
    *begin = _mm256_castps_si256(_mm256_shuffle_ps(low, high, 0x88));
    *end = _mm256_castps_si256(_mm256_shuffle_ps(low, high, 0xdd));
}
//<

//> Take eight tasks to their cells
USE_AVX2
INLINED __m256i cells_after(const enum geometry geometry,
                            const struct axis *axis, __m256i cell,
                            int32_t by)
{
    const __m256i m = _mm256_set1_epi32((int32_t)axis->count);
    __m256i to = _mm256_add_epi32(cell, _mm256_set1_epi32(by));
    if (geometry == STANDARD)
        return to;
    __m256i below = _mm256_srai_epi32(to, 31);
    __m256i above = _mm256_cmpgt_epi32(m, to);
    to = _mm256_add_epi32(to, _mm256_and_si256(below, m));
    return _mm256_sub_epi32(to, _mm256_andnot_si256(above, m));
}

USE_AVX2
INLINED void enter_in(const enum geometry geometry,
                      const struct map *map, struct strip *strip,
                      const struct tasks *tasks, int32_t dx, int32_t dy)
{
    const struct axis *x = &map->grid->x, *y = &map->grid->y;
    const __m256i columns = _mm256_set1_epi32((int32_t)x->count);
    const __m256i steps_x = _mm256_set1_epi32(abs(dx) - 1);
    const __m256i steps_y = _mm256_set1_epi32(abs(dy) - 1);
    const int32_t *bound_x = tasks->bound[dx < 0 ? WEST : EAST];
    const int32_t *bound_y = tasks->bound[dy < 0 ? SOUTH : NORTH];
    uint64_t visited = 0;
    uint32_t n = tasks->n, k = 0;
    put(tasks->bound[dx < 0 ? WEST : EAST] + n, _mm256_set1_epi32(-1));
    for (uint32_t i = 0; i < n; i += 8) {
        __m256i within = _mm256_and_si256(
            _mm256_cmpgt_epi32(eight(bound_x + i), steps_x),
            _mm256_cmpgt_epi32(eight(bound_y + i), steps_y));
        if (bits(within) == 0)
            continue;
        __m256i row =
            cells_after(geometry, y, eight(tasks->row + i), dy);
        __m256i cell = _mm256_add_epi32(
            _mm256_mullo_epi32(row, columns),
            cells_after(geometry, x, eight(tasks->column + i), dx));
        __m256i begin, end;
        bounds(map->cells->start, _mm256_and_si256(within, cell),
               &begin, &end);
        __m256i empty = _mm256_cmpeq_epi32(begin, end);
        visited += (unsigned)__builtin_popcount(bits(within));
        k = keep_visits(&strip->here, k,
                        bits(_mm256_andnot_si256(empty, within)),
                        eight(tasks->task + i), begin, end);
    }
    strip->tally.visited += visited;
    strip->here.n = k;
}
//<

//> Compare four points
USE_AVX2
INLINED void compare_four(const enum geometry geometry,
                          const struct map *map, struct strip *strip,
                          const uint32_t *task, const uint32_t *at)
{
    const struct points p = map->points;
    const uint32_t *point = map->cells->point;
    uint32_t j[4] = {point[at[0]], point[at[1]], point[at[2]],
                     point[at[3]]};
    __m256d d2 =
        four_near2(geometry, map->space,
                   _mm256_sub_pd(four(p.x, j), four(strip->x, task)),
                   _mm256_sub_pd(four(p.y, j), four(strip->y, task)));
    //> Turn the distance to oneself into NaN
    __m128i own = _mm_add_epi32(_mm_loadu_si128((const __m128i *)task),
                                _mm_set1_epi32((int)strip->first));
    __m128i self =
        _mm_cmpeq_epi32(own, _mm_loadu_si128((const __m128i *)at));
    d2 = _mm256_or_pd(d2, widen(self));
    //<
    //> Keep what is nearer in four lanes
    __m256d best2 = four(strip->best2, task);
    __m128i nearest = four32(strip->nearest, task);
    __m128i candidate = four32(point, at);
    __m128i lower =
        _mm_cmpeq_epi32(_mm_min_epu32(candidate, nearest), candidate);
    __m128i nearer = narrow(_mm256_cmp_pd(d2, best2, _CMP_LT_OQ));
    __m128i tie = narrow(_mm256_cmp_pd(d2, best2, _CMP_EQ_OQ));
    __m128i better = _mm_or_si128(nearer, _mm_and_si128(tie, lower));
    put_four(strip->best2, task,
             _mm256_blendv_pd(best2, d2, widen(better)));
    put_four32(strip->nearest, task,
               _mm_blendv_epi8(nearest, candidate, better));
    //<
}
//<

//> Compare all visits, eight at a time
// The last vector is filled up with visits of a task that is in no
// list, each with a single point left.
USE_AVX2
INLINED void compare_in(const enum geometry geometry,
                        const struct map *map, struct strip *strip)
{
    const struct visits *here = &strip->here;
    const __m256i one = _mm256_set1_epi32(1);
    uint32_t n = here->n, k = 0;
    put(here->task + n, _mm256_set1_epi32((int)strip->all.n));
    put(here->at + n, _mm256_setzero_si256());
    put(here->end + n, one);
    for (uint32_t i = 0; i < n; i += 8) {
        compare_four(geometry, map, strip, here->task + i,
                     here->at + i);
        compare_four(geometry, map, strip, here->task + i + 4,
                     here->at + i + 4);
        __m256i at = _mm256_add_epi32(eight(here->at + i), one);
        __m256i end = eight(here->end + i);
        k = keep_visits(here, k,
                        ~bits(_mm256_cmpeq_epi32(at, end)) & 0xff,
                        eight(here->task + i), at, end);
    }
    strip->here.n = k;
}
//<

#define TARGET USE_AVX2
#include "ch08-vector-spiral/both_geometries.h"

const struct spiral_kernels avx2_spiral = {AVX2, enter_cells,
                                           compare_points};
#endif
//<

//> Sort by detecting conflicts
// A lane's rank is the number of earlier lanes with the same cell. Its
// place is as many behind the next free one, and the last store to a
// cell, the highest rank's, stays. One step for eight points, however
// many of them collide.
#include "ch05-collisions/conflict.h"
#include "common/fail.h"
#include "common/isa.h"
#include <stdlib.h>

enum { LANES = 8 };

//> Take places for eight lanes
static void take(const uint32_t *cell_id, uint32_t lanes,
                 uint32_t *next, uint32_t *place)
{
    for (uint32_t k = 0; k < lanes; k++) {
        uint32_t rank = 0;
        for (uint32_t j = 0; j < k; j++)
            rank += cell_id[j] == cell_id[k];
        place[k] = next[cell_id[k]] + rank;
    }
    for (uint32_t k = 0; k < lanes; k++)
        next[cell_id[k]] = place[k] + 1;
}
//<

static uint32_t lanes_left(uint32_t left)
{
    return left < LANES ? left : LANES;
}

//> Count eight points at a time
static void count_portably(const uint32_t *cell_id, uint32_t n,
                           uint32_t *count)
{
    uint32_t place[LANES];
    for (size_t i = 0; i < n; i += LANES)
        take(cell_id + i, lanes_left(n - i), count, place);
}
//<

//> Place eight points at a time
static void place_portably(const uint32_t *cell_id, uint32_t n,
                           uint32_t *next, uint32_t *point)
{
    uint32_t place[LANES];
    for (size_t i = 0; i < n; i += LANES) {
        uint32_t lanes = lanes_left(n - i);
        take(cell_id + i, lanes, next, place);
        for (uint32_t k = 0; k < lanes; k++)
            point[place[k]] = i + k;
    }
}
//<

#ifdef HAVE_X86_VECTORS
#include <immintrin.h>

//> Rank eight lanes with one instruction
// Conflict detection sets bit j of lane k if j < k and the two are
// equal; the number of such bits is the rank.
USE_AVX512
static __m256i lane_ranks(__m256i id)
{
    const __m256i ones = _mm256_set1_epi32(0x55);
    const __m256i pairs = _mm256_set1_epi32(0x33);
    const __m256i half = _mm256_set1_epi32(0xf);
    __m256i b = _mm256_conflict_epi32(id);
    //> Count the ones of each lane
    b = _mm256_add_epi32(
        _mm256_and_si256(b, ones),
        _mm256_and_si256(_mm256_srli_epi32(b, 1), ones));
    b = _mm256_add_epi32(
        _mm256_and_si256(b, pairs),
        _mm256_and_si256(_mm256_srli_epi32(b, 2), pairs));
    return _mm256_add_epi32(_mm256_and_si256(b, half),
                            _mm256_srli_epi32(b, 4));
    //<
}
//<

//> Take eight places with the instruction
USE_AVX512
static __m256i take_avx512(const uint32_t *cell_id, __mmask8 here,
                           uint32_t *next)
{
    __m256i id = _mm256_maskz_loadu_epi32(here, cell_id);
    __m512i wide = _mm512_cvtepu32_epi64(id);
    __m256i next_free = _mm512_mask_i64gather_epi32(
        _mm256_setzero_si256(), here, wide, next, 4);
    __m256i place = _mm256_add_epi32(next_free, lane_ranks(id));
    __m256i after = _mm256_add_epi32(place, _mm256_set1_epi32(1));
    _mm512_mask_i64scatter_epi32(next, here, wide, after, 4);
    return place;
}
//<

//> Count with the instruction
static __mmask8 mask_left(uint32_t left)
{
    return left < LANES ? (1u << left) - 1 : 0xff;
}

USE_AVX512
static void count_avx512(const uint32_t *cell_id, uint32_t n,
                         uint32_t *count)
{
    for (size_t i = 0; i < n; i += LANES)
        take_avx512(cell_id + i, mask_left(n - i), count);
}
//<

//> Place with the instruction
USE_AVX512
static void place_avx512(const uint32_t *cell_id, uint32_t n,
                         uint32_t *next, uint32_t *point)
{
    __m256i number = _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7);
    for (size_t i = 0; i < n; i += LANES) {
        __mmask8 here = mask_left(n - i);
        __m256i place = take_avx512(cell_id + i, here, next);
        _mm512_mask_i64scatter_epi32(
            point, here, _mm512_cvtepu32_epi64(place), number, 4);
        number = _mm256_add_epi32(number, _mm256_set1_epi32(LANES));
    }
}
//<
#endif

//> Use the instruction where it is
void conflict_count(const uint32_t *cell_id, uint32_t n,
                    uint32_t *count)
{
#ifdef HAVE_X86_VECTORS
    if (isa_chosen() == AVX512) {
        count_avx512(cell_id, n, count);
        return;
    }
#endif
    count_portably(cell_id, n, count);
}

void conflict_place(const uint32_t *cell_id, uint32_t n, uint32_t *next,
                    uint32_t *point)
{
#ifdef HAVE_X86_VECTORS
    if (isa_chosen() == AVX512) {
        place_avx512(cell_id, n, next, point);
        return;
    }
#endif
    place_portably(cell_id, n, next, point);
}
//<

struct cells cells_sort_conflict(const struct grid *grid,
                                 struct points points)
{
    const uint32_t n = points.n, m = grid_cells(grid);
    struct cells cells = cells_allocate(m, n);
    uint32_t *cell_id = allocate(n, sizeof *cell_id);
    uint32_t *count = cells.start + 1;
    find_cell_ids(grid, points, 0, n, cell_id);
    conflict_count(cell_id, n, count);
    cells_scan(count, m, 0);
    conflict_place(cell_id, n, count, cells.point);
    free(cell_id);
    return cells;
}
//<

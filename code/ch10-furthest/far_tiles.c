//> Search far by tiles
// See far_tiles.h. If a pair is separated by a and b in a box of w by
// h, its furthest images lack a (2 w - a) + b (2 h - b) of the largest
// squared distance there is. We call that their loss; the furthest
// point has the least.
#include "ch10-furthest/far_tiles.h"
#include "ch09-row-spans/tile.h"
#include "ch10-furthest/furthest_cells.h"
#include "ch10-furthest/outside.h"
#include "common/isa.h"
#ifdef HAVE_X86_VECTORS
#include <immintrin.h>
#endif

// Finds the two least losses for each of the first eight in the table,
// of whom so many ask. Nobody meets himself.
typedef void loss_function(const struct table *table, uint32_t width,
                           struct space space, struct sieve *sieve);

//> Show a candidate's losses to eight
INLINED void show_losses(const struct table *table, uint32_t k,
                         float across, float up, struct sieve *s)
{
#pragma omp simd
    for (uint32_t lane = 0; lane < ASKING; lane++) {
        float dx = fabsf(table->x[k] - table->x[lane]);
        float dy = fabsf(table->y[k] - table->y[lane]);
        float loss = dx * (across - dx) + dy * (up - dy);
        uint32_t bits;
        memcpy(&bits, &loss, sizeof bits);
        bits = (bits & ~(uint32_t)NUMBER_BITS) | k;
        memcpy(&loss, &bits, sizeof bits);
        loss = lane == k ? FAR2 : loss;
        float best = s->best[lane], second = s->second[lane];
        float loser = best > loss ? best : loss;
        s->best[lane] = best < loss ? best : loss;
        s->second[lane] = second < loser ? second : loser;
    }
}
//<

//> Sift losses in plain C
static void sift_losses(const struct table *table, uint32_t width,
                        struct space space, struct sieve *sieve)
{
    const float across = (float)(2 * space.width);
    const float up = (float)(2 * space.height);
    struct sieve s;
    for (int lane = 0; lane < ASKING; lane++)
        s.best[lane] = s.second[lane] = FAR2;
    for (uint32_t k = 0; k < width; k++)
        show_losses(table, k, across, up, &s);
    for (uint32_t k = ASKING; k < table->count; k++)
        show_losses(table, k, across, up, &s);
    *sieve = s;
}
//<

//> Sift losses with AVX2
#ifdef HAVE_X86_VECTORS
struct losses {
    __m256 x, y, across, up, best, second;
};

USE_AVX2
INLINED __m256 losses_of(const struct losses *l,
                         const struct table *table, uint32_t k)
{
    const __m256 sign = _mm256_set1_ps(-0.0F);
    __m256 dx = _mm256_andnot_ps(
        sign, _mm256_sub_ps(_mm256_broadcast_ss(table->x + k), l->x));
    __m256 dy = _mm256_andnot_ps(
        sign, _mm256_sub_ps(_mm256_broadcast_ss(table->y + k), l->y));
    __m256 loss =
        _mm256_fmadd_ps(dx, _mm256_sub_ps(l->across, dx),
                        _mm256_mul_ps(dy, _mm256_sub_ps(l->up, dy)));
    return _mm256_castsi256_ps(_mm256_blendv_epi8(
        _mm256_castps_si256(loss), _mm256_set1_epi32((int)k),
        _mm256_set1_epi32(NUMBER_BITS)));
}

USE_AVX2
INLINED void losses_keep(struct losses *l, __m256 loss)
{
    __m256 loser = _mm256_max_ps(l->best, loss);
    l->best = _mm256_min_ps(l->best, loss);
    l->second = _mm256_min_ps(l->second, loser);
}

USE_AVX2
static void sift_losses_avx2(const struct table *table, uint32_t width,
                             struct space space, struct sieve *sieve)
{
    const __m256 far2 = _mm256_set1_ps(FAR2);
    const __m256i lane = _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7);
    struct losses l = {_mm256_loadu_ps(table->x),
                       _mm256_loadu_ps(table->y),
                       _mm256_set1_ps((float)(2 * space.width)),
                       _mm256_set1_ps((float)(2 * space.height)),
                       far2,
                       far2};
    for (uint32_t k = 0; k < width; k++) {
        __m256i self =
            _mm256_cmpeq_epi32(lane, _mm256_set1_epi32((int)k));
        losses_keep(&l, _mm256_blendv_ps(losses_of(&l, table, k), far2,
                                         _mm256_castsi256_ps(self)));
    }
    for (uint32_t k = ASKING; k < table->count; k++)
        losses_keep(&l, losses_of(&l, table, k));
    _mm256_storeu_ps(sieve->best, l.best);
    _mm256_storeu_ps(sieve->second, l.second);
}
#endif
//<

//> Choose how to sift losses
static loss_function *loss_sift(void)
{
#ifdef HAVE_X86_VECTORS
    if (isa_chosen() != PORTABLE)
        return sift_losses_avx2;
#endif
    return sift_losses;
}
//<

//> Know how far a loss can be off
// Staging and subtracting leaves a separation off by less than 5 *
// 2^-24 of the reach, which the loss multiplies by less than 2 w or 2
// h; all else is relative, and mostly the number in the low bits. A
// squared distance in double precision is off by less than 7 * 2^-53 of
// the largest. Two losses are compared, and 2^-12 of the lesser
// besides.
INLINED float loss_slack(struct space space, double reach)
{
    return (float)((space.width + space.height) * reach * 0x1p-19 +
                   (space.width * space.width +
                    space.height * space.height) *
                       0x1p-48);
}

// A table will do only if no separation in it is more than half a
// period, and no loss more than can be sifted.
INLINED bool losses_fit(struct space space, double reach)
{
    return 5 * reach <= least(space.width, space.height) &&
           most(space.width, space.height) <= 0x1p50;
}
//<

//> Find how far those outside can be
// Nobody outside of the block is further, as squares are computed, for
// a margin is at most half a period.
INLINED double furthest_outside2(const struct grid *grid,
                                 const struct block *block,
                                 struct space space, double x, double y)
{
    double w = space.width, h = space.height;
    double across = w - reach_margin(&grid->x, &block->x, x);
    double up = h - reach_margin(&grid->y, &block->y, y);
    return most(across * across + h * h, w * w + up * up) *
           (1 + 0x1p-48);
}
//<

//> Look from outside
// Whoever was found already need not be found again.
static struct viewer look_from_outside(const struct ground *ground,
                                       uint32_t s, uint32_t t,
                                       double far2)
{
    struct viewer viewer = viewer_of(ground->sorted, s);
    if (s != t) {
        viewer.most2 = far2;
        viewer.furthest = ground->sorted->cells.point[t];
    }
    seek_far(WRAPAROUND, look_at, ground, &viewer);
    COUNT(tasks, 1);
    return viewer;
}
//<

//> Answer those who are sure of their furthest
INLINED void answer_far(const struct ground *ground,
                        const struct tile *tile,
                        const struct table *table,
                        const struct sieve *sieve,
                        struct answers *found)
{
    const struct sorted *sorted = ground->sorted;
    const double *x = sorted->points.x, *y = sorted->points.y;
    const struct space space = ground->space;
    const float slack = loss_slack(space, tile->reach);
    for (uint32_t lane = 0; lane < tile->width; lane++) {
        uint32_t s = tile->begin + lane, k = s - tile->first;
        uint32_t t = table->place[number_of(sieve->best[lane])];
        double far2 =
            pair2(WRAPAROUND, space, x[t] - x[s], y[t] - y[s]).far2;
        bool sure = sieve->second[lane] >
                    sieve->best[lane] * (1 + 0x1p-12f) + slack;
        found->furthest[k] = sorted->cells.point[t];
        found->furthest2[k] = far2;
        if (!(sure &&
              far2 > furthest_outside2(&sorted->grid, &tile->block,
                                       space, x[s], y[s]))) {
            struct viewer viewer =
                look_from_outside(ground, s, t, far2);
            found->furthest[k] = viewer.furthest;
            found->furthest2[k] = viewer.most2;
        }
    }
}
//<

//> Stage for losses
INLINED void stage_far(const struct sorted *sorted, uint32_t begin,
                       uint32_t end, double x, double y,
                       struct table *table)
{
    stage_plainly(sorted, begin, end, x, y, table->count, table);
    table->count += end - begin;
}
//<

//> Ask far with a tile
INLINED void ask_far(loss_function *sift, const struct ground *ground,
                     struct tile *tile, struct answers *found)
{
    const struct sorted *sorted = ground->sorted;
    const struct grid *grid = &sorted->grid;
    const double *x = sorted->points.x + tile->begin;
    uint32_t from = axis_cell(&grid->x, x[0]);
    uint32_t to = axis_cell(&grid->x, x[tile->width - 1]);
    struct table table;
    struct sieve sieve = {{0}, {0}};
    tile->block = block_around(grid, tile->row, from, to, 1);
    if (fill(WRAPAROUND, stage_far, sorted, tile, from, to, &table) &&
        losses_fit(ground->space, tile->reach)) {
        sift(&table, tile->width, ground->space, &sieve);
        COUNT(distances,
              (uint64_t)(table.count - ASKING + tile->width) * ASKING);
    } else {
        table.place[0] = tile->begin;
    }
    answer_far(ground, tile, &table, &sieve, found);
}
//<

//> Go along and look far
// A tile ends where its row ends.
static void go_far(loss_function *sift, const struct ground *ground,
                   uint32_t begin, uint32_t end, struct answers *found)
{
    const struct grid *grid = &ground->sorted->grid;
    const uint32_t *start = ground->sorted->cells.start;
    struct tile tile = {
        .begin = begin,
        .first = begin,
        .row = axis_cell(&grid->y, ground->sorted->points.y[begin])};
    for (; tile.begin < end; tile.begin += tile.width) {
        uint32_t stop;
        while ((stop = start[(tile.row + 1) * grid->x.count]) <=
               tile.begin)
            tile.row++;
        tile.width = (stop < end ? stop : end) - tile.begin;
        tile.width = tile.width < ASKING ? tile.width : ASKING;
        ask_far(sift, ground, &tile, found);
    }
}
//<

//> Take a turn looking far
enum { FAR_TURN = 1024 };

static void take_far_turn(loss_function *sift,
                          const struct ground *ground, uint32_t begin,
                          uint32_t end, struct answers *answers)
{
    uint32_t furthest[FAR_TURN];
    double furthest2[FAR_TURN];
    struct answers found = {.furthest = furthest,
                            .furthest2 = furthest2};
    const uint32_t *point = ground->sorted->cells.point;
    go_far(sift, ground, begin, end, &found);
    for (uint32_t s = begin; s < end; s++) {
        answers->furthest[point[s]] = furthest[s - begin];
        answers->furthest2[point[s]] = furthest2[s - begin];
    }
}
//<

void search_far_tiles(const struct question *question,
                      const struct sorted *sorted,
                      struct answers *answers)
{
    loss_function *const sift = loss_sift();
    const uint32_t n = sorted->points.n, turns = (n - 1) / FAR_TURN + 1;
    struct rows rows = rows_find(sorted);
    const struct ground ground = {sorted, &rows, question->space};
#pragma omp parallel for num_threads(question->threads) \
    schedule(dynamic)
    for (uint32_t turn = 0; turn < turns; turn++) {
        uint32_t begin = turn * FAR_TURN, left = n - begin;
        take_far_turn(sift, &ground, begin,
                      begin + (left < FAR_TURN ? left : FAR_TURN),
                      answers);
    }
    rows_free(&rows);
}
//<

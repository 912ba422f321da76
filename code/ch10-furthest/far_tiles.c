//> Search far by tiles
// See far_tiles.h. If a pair is separated by a and b in a box of w by
// h, its furthest images lack a (2 w - a) + b (2 h - b) of the largest
// squared distance there is. We call that their loss; the furthest
// point has the least.
#include "ch10-furthest/far_tiles.h"
#include "ch09-row-spans/row_spans.h"
#include "ch09-row-spans/window.h"
#include "ch10-furthest/furthest_cells.h"
#include "ch10-furthest/outside.h"
#include "common/isa.h"
#ifdef HAVE_X86_VECTORS
#include "ch09-row-spans/avx512_window.h"
#endif

// Finds the two least losses for each of the first eight in the table.
// Nobody meets himself.
typedef void loss_function(const struct table *table,
                           struct space space, struct sieve *sieve);

//> Show a candidate's losses to eight
// Nobody, who stands at FAR, must not seem to be near: his loss is
// huge, but less than 0.
INLINED void show_losses(const struct table *table, uint32_t k,
                         float across, float up, struct sieve *s)
{
#pragma omp simd
    for (uint32_t lane = 0; lane < ASKING; lane++) {
        float dx = fabsf(table->x[k] - table->x[lane]);
        float dy = fabsf(table->y[k] - table->y[lane]);
        float loss = fabsf(dx * (across - dx) + dy * (up - dy));
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
static void sift_losses(const struct table *table, struct space space,
                        struct sieve *sieve)
{
    const float across = (float)(2 * space.width);
    const float up = (float)(2 * space.height);
    struct sieve s;
    for (int lane = 0; lane < ASKING; lane++)
        s.best[lane] = s.second[lane] = FAR2;
    for (uint32_t k = 0; k < table->count; k++)
        show_losses(table, k, across, up, &s);
    *sieve = s;
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

//> Look around
// Shows the sorted points begin .. end - 1 to one who looks far.
static void look_along(const struct ground *ground, uint32_t begin,
                       uint32_t end, struct viewers *viewer)
{
    for (uint32_t s = begin; s < end; s++)
        show(WRAPAROUND, 1, ground->space, ground->sorted, s, viewer);
    COUNT(distances, end - begin);
}

// In a block that is wider by a cell on each side. Says whether nobody
// outside of that can be further.
static bool look_around(const struct ground *ground,
                        struct viewers *viewer)
{
    const struct grid *grid = &ground->sorted->grid;
    const uint32_t columns = grid->x.count;
    const struct block block =
        block_of(grid, viewer->x[0], viewer->y[0], 2);
    const uint32_t first = block.x.first, end = first + block.x.count;
    for (uint32_t k = 0; k < block.y.count; k++) {
        const uint32_t *start =
            ground->sorted->cells.start +
            reach_cell(&grid->y, &block.y, k) * columns;
        look_along(ground, start[first],
                   start[end < columns ? end : columns], viewer);
        if (end > columns)
            look_along(ground, start[0], start[end - columns], viewer);
    }
    return viewer->most2[0] >
           furthest_outside2(grid, &block, ground->space, viewer->x[0],
                             viewer->y[0]);
}
//<

//> Look far alone
// Whoever was found already need not be found again. Who still cannot
// be sure begins from outside. Number k of found is sorted point s.
static void look_far_alone(const struct ground *ground, uint32_t s,
                           uint32_t k, struct answers *found)
{
    struct viewers viewer;
    set_viewers(1, ground->sorted, s, &viewer);
    if (found->furthest[k] != viewer.self[0]) {
        viewer.most2[0] = found->furthest2[k];
        viewer.furthest[0] = found->furthest[k];
    }
    if (!look_around(ground, &viewer))
        seek_far(WRAPAROUND, 1, ground, &viewer);
    found->furthest[k] = viewer.furthest[0];
    found->furthest2[k] = viewer.most2[0];
    COUNT(tasks, 1);
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
                                       space, x[s], y[s])))
            look_far_alone(ground, s, k, found);
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
                     struct tile tile, struct answers *found)
{
    const struct sorted *sorted = ground->sorted;
    const struct grid *grid = &sorted->grid;
    const double *x = sorted->points.x + tile.begin;
    uint32_t from = axis_cell(&grid->x, x[0]);
    uint32_t to = axis_cell(&grid->x, x[tile.width - 1]);
    struct table table;
    struct sieve sieve = {{0}, {0}};
    tile.block = block_around(grid, tile.row, from, to, 1);
    if (fill(WRAPAROUND, stage_far, sorted, &tile, from, to, &table) &&
        losses_fit(ground->space, tile.reach)) {
        sift(&table, ground->space, &sieve);
        COUNT(distances, (uint64_t)table.count * ASKING);
    } else {
        table.place[0] = tile.begin;
    }
    answer_far(ground, &tile, &table, &sieve, found);
}
//<

//> See losses with AVX2
#ifdef HAVE_X86_VECTORS
USE_AVX2
INLINED __m256 see_loss(const struct eye *eye, __m256 dx, __m256 dy)
{
    const __m256 sign = _mm256_set1_ps(-0.0F);
    dx = _mm256_andnot_ps(sign, dx);
    dy = _mm256_andnot_ps(sign, dy);
    __m256 loss =
        _mm256_fmadd_ps(dx, _mm256_sub_ps(eye->across, dx),
                        _mm256_mul_ps(dy, _mm256_sub_ps(eye->up, dy)));
    return _mm256_andnot_ps(sign, loss);
}
//<

//> Settle four furthest
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
INLINED uint32_t settle_far(const enum geometry geometry,
                            struct space space, const struct grid *grid,
                            const struct block *block,
                            const struct quartet *four, double far2[4])
{
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
        _mm256_set1_pd(1 + 0x1p-48));
    _mm256_storeu_pd(far2, d2);
    return (uint32_t)_mm256_movemask_pd(
        _mm256_cmp_pd(d2, outside2, _CMP_GT_OQ));
}
//<

//> Look far with AVX2
USE_AVX2
static void sift_losses_avx2(const struct table *table,
                             struct space space, struct sieve *sieve)
{
    const float *x = table->x, *y = table->y;
    uint32_t number[ASKING] = {0, 1, 2, 3, 4, 5, 6, 7};
    struct eye eye = eye_for(space, x, y);
    glance_at_own(see_loss, x, y, number, &eye);
    for (uint32_t k = ASKING; k < table->count; k++)
        keep_two(&eye.two, glance_at(see_loss, &eye, x + k, y + k, &k));
    _mm256_storeu_ps(sieve->best, eye.two.best);
    _mm256_storeu_ps(sieve->second, eye.two.second);
}

USE_AVX2
static uint32_t glance_far_avx2(const struct ground *ground,
                                const struct window *window,
                                const struct tile *tile,
                                struct reply *reply)
{
    const struct space space = ground->space;
    struct sieve sieve;
    sweep(see_loss, space, ground->sorted, window, tile, &sieve);
    return reply_to_eight(settle_far, WRAPAROUND, space,
                          loss_slack(space, tile->reach),
                          ground->sorted, window, tile, &sieve, reply);
}
//<

//> Look far with AVX-512
USE_AVX512
INLINED __m512 see_loss_wide(const struct wide_eye *eye, __m512 dx,
                             __m512 dy)
{
    dx = _mm512_abs_ps(dx);
    dy = _mm512_abs_ps(dy);
    return _mm512_abs_ps(
        _mm512_fmadd_ps(dx, _mm512_sub_ps(eye->across, dx),
                        _mm512_mul_ps(dy, _mm512_sub_ps(eye->up, dy))));
}

USE_AVX512
static uint32_t glance_far_avx512(const struct ground *ground,
                                  const struct window *window,
                                  const struct tile *tile,
                                  struct reply *reply)
{
    const struct space space = ground->space;
    struct sieve sieve;
    sweep_wide(see_loss_wide, space, ground->sorted, window, tile,
               &sieve);
    return reply_to_eight(settle_far, WRAPAROUND, space,
                          loss_slack(space, tile->reach),
                          ground->sorted, window, tile, &sieve, reply);
}
#endif
//<

//> Choose how to look far
// With plain C, no window is ever open.
struct sight {
    loss_function *sift;
    uint32_t (*glance)(const struct ground *ground,
                       const struct window *window,
                       const struct tile *tile, struct reply *reply);
};

static struct sight sight_of(enum isa isa)
{
#ifdef HAVE_X86_VECTORS
    if (isa == AVX512)
        return (struct sight){sift_losses_avx2, glance_far_avx512};
    if (isa == AVX2)
        return (struct sight){sift_losses_avx2, glance_far_avx2};
#endif
    (void)isa;
    return (struct sight){sift_losses, NULL};
}
//<

//> Look far through a window
static void look_through(const struct sight *sight,
                         const struct ground *ground,
                         const struct window *window,
                         const struct tile *tile, struct answers *found)
{
    const uint32_t k = tile->begin - tile->first, width = tile->width;
    struct reply reply;
    uint32_t sure = sight->glance(ground, window, tile, &reply);
    memcpy(found->furthest2 + k, reply.d2, width * sizeof(double));
    memcpy(found->furthest + k, reply.who, width * sizeof(uint32_t));
    for (uint32_t lane = 0; lane < width; lane++)
        if (!(sure >> lane & 1))
            look_far_alone(ground, tile->begin + lane, k + lane, found);
}
//<

//> Visit a tile to look far
struct far_visit {
    struct sight sight;
    struct ground ground;
};

static void visit_far(const void *context, const struct window *window,
                      const struct tile *tile, struct answers *found)
{
    const struct far_visit *visit = context;
    if (window && losses_fit(visit->ground.space, window->reach))
        look_through(&visit->sight, &visit->ground, window, tile,
                     found);
    else
        ask_far(visit->sight.sift, &visit->ground, *tile, found);
}
//<

//> Search near and far by tiles
void search_far_tiles(const struct question *question,
                      const struct carried *carried,
                      struct answers *answers)
{
    struct rows rows = rows_find(&carried->sorted);
    const struct far_visit far = {
        sight_of(isa_chosen()),
        {&carried->sorted, &rows, question->space}};
    const struct visit visit = {visit_far, &far};
    search_and_visit(question, carried, &visit, answers);
    rows_free(&rows);
}
//<
//<

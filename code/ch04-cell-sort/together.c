//> Search with four points together
// See together.h.
#include "ch04-cell-sort/together.h"
#include "ch02-all-pairs/pair.h"
#include "ch04-cell-sort/block.h"
#include "common/clock.h"
#include "common/count.h"

enum { ASKING = 4, STRIPE = 64, STRIPES_PER_TURN = 4 };

//> Hold four points of a row
struct asking {
    double x[ASKING], y[ASKING], best2[ASKING];
    double self[ASKING], nearest[ASKING]; // indices
};
//<

//> Show a stretch of candidates to all who ask
INLINED void sweep(const enum geometry geometry, struct space space,
                   struct points sorted, const uint32_t *point,
                   uint32_t begin, uint32_t end, struct asking *a)
{
    for (uint32_t s = begin; s < end; s++) {
        const double j = point[s];
        double distance2[ASKING];
#pragma omp simd
        for (int lane = 0; lane < ASKING; lane++) {
            distance2[lane] =
                pair2(geometry, space, sorted.x[s] - a->x[lane],
                      sorted.y[s] - a->y[lane])
                    .near2;
        }
        //> Keep the nearest of each lane
#pragma omp simd
        for (int lane = 0; lane < ASKING; lane++) {
            double d2 = distance2[lane];
            bool better =
                ((d2 < a->best2[lane]) |
                 ((d2 == a->best2[lane]) & (j < a->nearest[lane]))) &
                (j != a->self[lane]);
            a->best2[lane] = better ? d2 : a->best2[lane];
            a->nearest[lane] = better ? j : a->nearest[lane];
        }
        //<
    }
    COUNT(distances, (uint64_t)(end - begin) * ASKING);
}
//<

//> Sweep a block
INLINED void sweep_block(const enum geometry geometry,
                         struct space space,
                         const struct sorted *sorted,
                         const struct block *block,
                         struct asking *asking)
{
    const uint32_t columns = sorted->grid.x.count;
    const uint32_t rows = sorted->grid.y.count;
    const uint32_t *point = sorted->cells.point;
    const uint32_t end = block->x.first + block->x.count;
    for (uint32_t k = 0; k < block->y.count; k++) {
        uint32_t row = block->y.first + k;
        row -= row < rows ? 0 : rows;
        const uint32_t *start = sorted->cells.start + row * columns;
        sweep(geometry, space, sorted->points, point,
              start[block->x.first],
              start[end < columns ? end : columns], asking);
        if (end > columns)
            sweep(geometry, space, sorted->points, point, start[0],
                  start[end - columns], asking);
    }
    COUNT(cells, (uint64_t)block->x.count * block->y.count);
}
//<

//> Seat the points that ask
// Lanes to spare are seated with the points that follow, as far as
// there are any, and have found what they want.
INLINED void seat(struct asking *a, struct points sorted,
                  const uint32_t *point, uint32_t begin, uint32_t last,
                  int width)
{
#pragma omp simd
    for (int lane = 0; lane < ASKING; lane++) {
        uint64_t s = (uint64_t)begin + lane;
        s = s < last ? s : last;
        a->x[lane] = sorted.x[s];
        a->y[lane] = sorted.y[s];
        a->self[lane] = point[s];
        a->best2[lane] = lane < width ? INFINITY : -INFINITY;
        a->nearest[lane] = UINT32_MAX;
    }
}
//<

//> Test all lanes
// How many of them have no neighbor that is nearer than the margin.
INLINED double lacking(const struct grid *grid,
                       const struct block *block,
                       const struct asking *a)
{
    double count = 0;
#pragma omp simd reduction(+ : count)
    for (int lane = 0; lane < ASKING; lane++) {
        double margin =
            block_margin(grid, block, a->x[lane], a->y[lane]);
        count += a->best2[lane] < margin * margin ? 0 : 1;
    }
    return count;
}
//<

//> Ask until the block suffices all
INLINED void ask(const enum geometry geometry, struct space space,
                 const struct sorted *sorted, uint32_t row,
                 uint32_t begin, int width, struct answers *answers)
{
    const struct grid *grid = &sorted->grid;
    const struct points p = sorted->points;
    const uint32_t *point = sorted->cells.point;
    uint32_t from = axis_cell(&grid->x, p.x[begin]);
    uint32_t to = axis_cell(&grid->x, p.x[begin + width - 1]);
    struct asking asking;
    if (p.n - begin >= ASKING) // no need to look where it ends
        seat(&asking, p, point, begin, UINT32_MAX, width);
    else
        seat(&asking, p, point, begin, p.n - 1, width);
    for (uint32_t radius = 1;; radius *= 2) {
        struct block block = block_around(grid, row, from, to, radius);
        sweep_block(geometry, space, sorted, &block, &asking);
        if (lacking(grid, &block, &asking) == 0 ||
            block_covers(grid, &block))
            break;
    }
    for (int lane = 0; lane < width; lane++) {
        uint32_t i = point[begin + lane];
        answers->nearest[i] = asking.nearest[lane];
        answers->nearest2[i] = asking.best2[lane];
    }
}
//<

//> Go along the rows
// A stripe is a part of a row, so that even one row can be shared out.
INLINED void search(const enum geometry geometry,
                    const struct question *question,
                    const struct sorted *sorted,
                    struct answers *answers)
{
    const uint32_t columns = sorted->grid.x.count;
    const uint32_t rows = sorted->grid.y.count;
#pragma omp parallel for num_threads(question->threads) \
    schedule(dynamic, STRIPES_PER_TURN) collapse(2)
    for (uint32_t row = 0; row < rows; row++)
        for (uint32_t column = 0; column < columns; column += STRIPE) {
            const uint32_t *start = sorted->cells.start + row * columns;
            uint32_t beyond = column + STRIPE;
            uint32_t end = start[beyond < columns ? beyond : columns];
            for (uint64_t s = start[column]; s < end; s += ASKING)
                ask(geometry, question->space, sorted, row, s,
                    end - s < ASKING ? (int)(end - s) : ASKING,
                    answers);
        }
}

void search_together(const struct question *question,
                     const struct sorted *sorted,
                     struct answers *answers)
{
    if (question->space.geometry == STANDARD)
        search(STANDARD, question, sorted, answers);
    else
        search(WRAPAROUND, question, sorted, answers);
}
//<

//> Sort and search
void sort_and_search(const struct question *question, cell_sort *sort,
                     struct answers *answers)
{
    struct sorted sorted = sorted_make(question, POINTS_PER_CELL, sort);
    answers->built_ns = clock_ns();
    search_together(question, &sorted, answers);
    sorted_free(&sorted);
}

void cells_together(const struct question *question,
                    struct answers *answers)
{
    sort_and_search(question, cells_sort_alone, answers);
}
//<
//<

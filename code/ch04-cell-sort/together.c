//> Search with the points of a cell together
// See together.h.
#include "ch04-cell-sort/together.h"
#include "ch02-all-pairs/pair.h"
#include "ch04-cell-sort/block.h"
#include "common/clock.h"
#include "common/count.h"

enum { ASKING = 4, CELLS_PER_TURN = 256 };

//> Hold a few points of a cell
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
#pragma omp simd
        for (int lane = 0; lane < ASKING; lane++) {
            double d2 = pair2(geometry, space, sorted.x[s] - a->x[lane],
                              sorted.y[s] - a->y[lane])
                            .near2;
            bool better =
                ((d2 < a->best2[lane]) |
                 ((d2 == a->best2[lane]) & (j < a->nearest[lane]))) &
                (j != a->self[lane]);
            a->best2[lane] = better ? d2 : a->best2[lane];
            a->nearest[lane] = better ? j : a->nearest[lane];
        }
    }
    COUNT(distances, (uint64_t)(end - begin) * ASKING);
}
//<

//> Sweep a block
INLINED void sweep_block(const enum geometry geometry,
                         const struct question *question,
                         const struct grid *grid,
                         const struct cells *cells,
                         struct points sorted,
                         const struct block *block,
                         struct asking *asking)
{
    const uint32_t columns = grid->x.count, rows = grid->y.count;
    const uint32_t end = block->x.first + block->x.count;
    for (uint32_t k = 0; k < block->y.count; k++) {
        uint32_t row = block->y.first + k;
        row -= row < rows ? 0 : rows;
        const uint32_t *start = cells->start + row * columns;
        sweep(geometry, question->space, sorted, cells->point,
              start[block->x.first],
              start[end < columns ? end : columns], asking);
        if (end > columns)
            sweep(geometry, question->space, sorted, cells->point,
                  start[0], start[end - columns], asking);
    }
    COUNT(cells, (uint64_t)block->x.count * block->y.count);
}
//<

//> Seat the points that ask
// Spare lanes have found what they want.
INLINED void seat(struct asking *a, struct points sorted,
                  const uint32_t *point, uint32_t begin, uint32_t last,
                  int width)
{
#pragma omp simd
    for (int lane = 0; lane < ASKING; lane++) {
        uint64_t s = (uint64_t)begin + lane;
        if (s > last)
            s = last;
        a->x[lane] = sorted.x[s];
        a->y[lane] = sorted.y[s];
        a->self[lane] = point[s];
        a->best2[lane] = lane < width ? INFINITY : -INFINITY;
        a->nearest[lane] = UINT32_MAX;
    }
}
//<

//> Ask until the block suffices
INLINED void ask(const enum geometry geometry,
                 const struct question *question,
                 const struct grid *grid, const struct cells *cells,
                 struct points sorted, uint32_t cell, uint32_t begin,
                 int width, struct answers *answers)
{
    struct asking asking;
    if (sorted.n - begin >= ASKING)
        seat(&asking, sorted, cells->point, begin, UINT32_MAX, width);
    else
        seat(&asking, sorted, cells->point, begin, sorted.n - 1, width);
    bool enough = false;
    for (uint32_t radius = 1; !enough; radius *= 2) {
        struct block block = block_around(grid, cell, radius);
        sweep_block(geometry, question, grid, cells, sorted, &block,
                    &asking);
        double lacking = 0;
#pragma omp simd reduction(+ : lacking)
        for (int lane = 0; lane < ASKING; lane++) {
            double m = block_margin(grid, &block, asking.x[lane],
                                    asking.y[lane]);
            lacking += asking.best2[lane] < m * m ? 0 : 1;
        }
        enough = lacking == 0 || block_covers(grid, &block);
    }
    for (int lane = 0; lane < width; lane++) {
        uint32_t i = cells->point[begin + lane];
        answers->nearest[i] = asking.nearest[lane];
        answers->nearest2[i] = asking.best2[lane];
    }
}
//<

//> Go from cell to cell
INLINED void search(const enum geometry geometry,
                    const struct question *question,
                    const struct grid *grid, const struct cells *cells,
                    struct points sorted, struct answers *answers)
{
    const uint32_t m = grid_cells(grid);
#pragma omp parallel for num_threads(question->threads) \
    schedule(dynamic, CELLS_PER_TURN)
    for (uint32_t cell = 0; cell < m; cell++) {
        uint32_t end = cells->start[cell + 1];
        for (uint32_t s = cells->start[cell]; s < end; s += ASKING)
            ask(geometry, question, grid, cells, sorted, cell, s,
                end - s < ASKING ? (int)(end - s) : ASKING, answers);
    }
}

void search_together(const struct question *question,
                     const struct grid *grid, const struct cells *cells,
                     struct points sorted, struct answers *answers)
{
    if (question->space.geometry == STANDARD)
        search(STANDARD, question, grid, cells, sorted, answers);
    else
        search(WRAPAROUND, question, grid, cells, sorted, answers);
}
//<

//> Sort and search
void cells_together(const struct question *question,
                    struct answers *answers)
{
    struct grid grid = grid_fit(question, POINTS_PER_CELL);
    struct cells cells = cells_sort(&grid, question->points);
    struct points sorted =
        points_in_order(question->points, cells.point);
    answers->built_ns = clock_ns();
    search_together(question, &grid, &cells, sorted, answers);
    points_free(&sorted);
    cells_free(&cells);
    grid_free(&grid);
}
//<
//<

//> Search in batches of four
// Four queries of a row share a block and go through its rows together,
// one candidate at a time, one query in each lane; the block is widened
// until it suffices for all four. About 9 c + 10 distances a query.
#include "ch04-cell-sort/batches.h"
#include "ch02-all-pairs/pair.h"
#include "ch04-cell-sort/block.h"

enum { BATCH = 4, STRIPE = 64, STRIPES_PER_CHUNK = 4 };

//> Hold a batch of four queries
struct batch {
    uint32_t row, begin; // its row of cells; the place of its first
    int width;           // queries, 1 .. BATCH; other lanes are idle
    double x[BATCH], y[BATCH];
    double self[BATCH], nearest[BATCH]; // indices
    double best2[BATCH];
    struct counts *counts; // of the thread
};
//<

//> Compare a batch with a stretch of candidates
// And returns how many there are.
INLINED uint32_t compare_stretch(const enum geometry geometry,
                                 struct space space,
                                 const struct sorted *sorted,
                                 uint32_t begin, uint32_t end,
                                 struct batch *b)
{
    const struct points p = sorted->points;
    for (uint32_t s = begin; s < end; s++) {
        const double j = sorted->cells.point[s];
        double distance2[BATCH];
#pragma omp simd
        for (int lane = 0; lane < BATCH; lane++) {
            distance2[lane] =
                pair2(geometry, space, p.x[s] - b->x[lane],
                      p.y[s] - b->y[lane])
                    .near2;
        }
        //> Keep the nearest of each lane
#pragma omp simd
        for (int lane = 0; lane < BATCH; lane++) {
            double d2 = distance2[lane];
            bool better =
                ((d2 < b->best2[lane]) |
                 ((d2 == b->best2[lane]) & (j < b->nearest[lane]))) &
                (j != b->self[lane]);
            b->best2[lane] = better ? d2 : b->best2[lane];
            b->nearest[lane] = better ? j : b->nearest[lane];
        }
        //<
    }
    return end - begin;
}
//<

//> Go through the rows of a block
INLINED void visit_rows(const enum geometry geometry,
                        struct space space, const struct sorted *sorted,
                        const struct block *block, struct batch *batch)
{
    const struct grid *grid = &sorted->grid;
    const uint32_t columns = grid->x.count;
    const uint32_t first = block->x.first;
    const uint32_t end = first + block->x.count;
    uint32_t candidates = 0;
    for (uint32_t k = 0; k < block->y.count; k++) {
        uint32_t row = range_cell(&grid->y, &block->y, k);
        const uint32_t *start = sorted->cells.start + row * columns;
        candidates += compare_stretch(
            geometry, space, sorted, start[first],
            start[end < columns ? end : columns], batch);
        if (end > columns) // on round the axis
            candidates +=
                compare_stretch(geometry, space, sorted, start[0],
                                start[end - columns], batch);
    }
    batch->counts->distances += (uint64_t)candidates * BATCH;
    batch->counts->cells += (uint64_t)block->x.count * block->y.count;
}
//<

//> Fill the lanes
// Idle lanes are filled with the points that follow, as far as there
// are any, and never find a better candidate.
INLINED void fill(struct batch *b, const struct sorted *sorted)
{
    const uint64_t last = sorted->points.n - 1;
#pragma omp simd
    for (int lane = 0; lane < BATCH; lane++) {
        uint64_t s = (uint64_t)b->begin + lane;
        s = s < last ? s : last;
        b->x[lane] = sorted->points.x[s];
        b->y[lane] = sorted->points.y[s];
        b->self[lane] = sorted->cells.point[s];
        b->best2[lane] = lane < b->width ? INFINITY : -INFINITY;
        b->nearest[lane] = UINT32_MAX;
    }
}
//<

//> Count the lanes that need a wider block
INLINED double unverified(const struct grid *grid,
                          const struct block *block,
                          const struct batch *b)
{
    double count = 0;
#pragma omp simd reduction(+ : count)
    for (int lane = 0; lane < BATCH; lane++) {
        double margin =
            block_margin(grid, block, b->x[lane], b->y[lane]);
        count += b->best2[lane] < margin * margin ? 0 : 1;
    }
    return count;
}
//<

//> Widen the block until it suffices for all four
INLINED void search_batch(const enum geometry geometry,
                          struct space space,
                          const struct sorted *sorted,
                          struct batch *batch)
{
    const struct grid *grid = &sorted->grid;
    const double *x = sorted->points.x + batch->begin;
    uint32_t from = axis_cell(&grid->x, x[0]);
    uint32_t to = axis_cell(&grid->x, x[batch->width - 1]);
    for (uint32_t radius = 1;; radius *= 2) {
        struct block block =
            block_around(grid, batch->row, from, to, radius);
        visit_rows(geometry, space, sorted, &block, batch);
        if (unverified(grid, &block, batch) == 0 ||
            block_covers(grid, &block))
            break;
    }
}
//<

//> Search a stripe of a row
// The points in places begin .. end-1, four at a time.
INLINED void search_stripe(const enum geometry geometry,
                           const struct question *question,
                           const struct sorted *sorted,
                           struct batch batch, uint32_t end,
                           struct answers *answers)
{
    for (uint64_t s = batch.begin; s < end; s += BATCH) {
        batch.begin = s;
        batch.width = end - s < BATCH ? (int)(end - s) : BATCH;
        fill(&batch, sorted);
        search_batch(geometry, question->space, sorted, &batch);
        for (int lane = 0; lane < batch.width; lane++) {
            uint32_t i = sorted->cells.point[s + lane];
            answers->nearest[i] = batch.nearest[lane];
            answers->nearest2[i] = batch.best2[lane];
        }
    }
}
//<

//> Share out the rows in stripes
// A stripe is a part of a row, so that even one row can be shared out.
INLINED void search(const enum geometry geometry,
                    const struct question *question,
                    const struct sorted *sorted,
                    struct answers *answers)
{
    const uint32_t columns = sorted->grid.x.count;
    const uint32_t rows = sorted->grid.y.count;
#pragma omp parallel num_threads(question->threads)
    {
        struct counts mine = {0};
#pragma omp for schedule(dynamic, STRIPES_PER_CHUNK) collapse(2)
        for (uint32_t row = 0; row < rows; row++)
            for (uint32_t k = 0; k < columns; k += STRIPE) {
                //> Search the next stripe
                const uint32_t *start =
                    sorted->cells.start + row * columns;
                uint32_t beyond = k + STRIPE;
                struct batch batch = {
                    .row = row, .begin = start[k], .counts = &mine};
                search_stripe(
                    geometry, question, sorted, batch,
                    start[beyond < columns ? beyond : columns],
                    answers);
                //<
            }
        counts_add(question->counts, &mine);
    }
}

void search_batches(const struct question *question,
                    const struct sorted *sorted,
                    struct answers *answers)
{
    IN_GEOMETRY(question->space, search, question, sorted, answers);
}
//<

//> Sort and search
void cells_batched(const struct question *question,
                   struct answers *answers)
{
    struct sorted sorted = sorted_make(question, POINTS_PER_CELL);
    search_batches(question, &sorted, answers);
    sorted_free(&sorted);
}
//<
//<

// Nine cells and no further. About 9 c distances for c points in a
// cell, and 1 - q^2 of the answers are wrong (expected_wrong).
#include "ch04-cell-sort/experiments/nine_cells.h"
#include "ch04-cell-sort/visit.h"
#include <stddef.h>

INLINED void search(const enum geometry geometry,
                    const struct question *question,
                    const struct storage *storage,
                    struct answers *answers)
{
    const struct grid *grid = storage->grid;
    const struct points p = storage->points;
    struct counts counts = {0};
    for (uint32_t s = 0; s < p.n; s++) {
        uint32_t i = storage->index[s];
        //> Look at nine cells and no further
        struct query query = query_at(p.x[s], p.y[s], i, &counts);
        struct block block = block_of(grid, query.x, query.y, 1);
        visit_block(geometry, question->space, storage, &block,
                    visit_sorted, &query);
        answers->nearest[i] = query.nearest;
        answers->nearest2[i] = query.best2;
        //<
    }
    counts_add(question->counts, &counts);
}

void search_nine_cells(const struct question *question,
                       const struct sorted *sorted,
                       struct answers *answers)
{
    struct storage storage = {&sorted->grid, NULL, &sorted->cells,
                              sorted->points, sorted->cells.point};
    if (question->space.geometry == STANDARD)
        search(STANDARD, question, &storage, answers);
    else
        search(WRAPAROUND, question, &storage, answers);
}

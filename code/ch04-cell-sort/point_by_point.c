//> Search point by point
// A query is compared with the points of nine cells; if its best
// distance is not less than that to the nearest border of this block,
// the block is widened. About 9 c distances for c points in a cell.
#include "ch04-cell-sort/point_by_point.h"
#include "ch04-cell-sort/visit.h"
#include <stddef.h>

enum { POINTS_PER_CHUNK = 256 };

// Chosen by measurement, each for its search.
static const double per_list = 1, per_cell = 1;

//> Widen the block until it suffices
INLINED void widen(const enum geometry geometry, struct space space,
                   const struct storage *storage, visit_function *visit,
                   struct query *query)
{
    const struct grid *grid = storage->grid;
    for (uint32_t radius = 1;; radius *= 2) {
        struct block block = block_of(grid, query->x, query->y, radius);
        visit_block(geometry, space, storage, &block, visit, query);
        double margin = block_margin(grid, &block, query->x, query->y);
        if (query->best2 < margin * margin ||
            block_covers(grid, &block))
            break;
    }
}
//<

//> Make every point a query
INLINED void search(const enum geometry geometry,
                    const struct question *question,
                    const struct storage *storage,
                    const uint32_t *order, visit_function *visit,
                    struct answers *answers)
{
    const struct points p = storage->points;
#pragma omp parallel num_threads(question->threads)
    {
        struct counts mine = {0};
#pragma omp for schedule(dynamic, POINTS_PER_CHUNK)
        for (uint32_t k = 0; k < p.n; k++) {
            uint32_t s = order ? order[k] : k;
            uint32_t i = storage->index ? storage->index[s] : s;
            struct query query = query_at(p.x[s], p.y[s], i, &mine);
            widen(geometry, question->space, storage, visit, &query);
            answers->nearest[i] = query.nearest;
            answers->nearest2[i] = query.best2;
        }
        counts_add(question->counts, &mine);
    }
}
//<

//> Search with each way to store cells
void search_lists(const struct question *question,
                  const struct grid *grid, const struct lists *lists,
                  const uint32_t *order, struct answers *answers)
{
    struct storage storage = {grid, lists, NULL, question->points,
                              NULL};
    IN_GEOMETRY(question->space, search, question, &storage, order,
                visit_list, answers);
}

void search_indices(const struct question *question,
                    const struct grid *grid, const struct cells *cells,
                    const uint32_t *order, struct answers *answers)
{
    struct storage storage = {grid, NULL, cells, question->points,
                              NULL};
    IN_GEOMETRY(question->space, search, question, &storage, order,
                visit_indices, answers);
}

void search_sorted(const struct question *question,
                   const struct sorted *sorted, struct answers *answers)
{
    struct storage storage = {&sorted->grid, NULL, &sorted->cells,
                              sorted->points, sorted->cells.point};
    IN_GEOMETRY(question->space, search, question, &storage, NULL,
                visit_sorted, answers);
}
//<

//> Make the structure and search
void cells_lists(const struct question *question,
                 struct answers *answers)
{
    struct grid grid = grid_fit(question, per_list);
    struct lists lists = lists_make(&grid, question->points);
    note_built(question);
    search_lists(question, &grid, &lists, NULL, answers);
    lists_free(&lists);
    grid_free(&grid);
}

void cells_indices(const struct question *question,
                   struct answers *answers)
{
    struct grid grid = grid_fit(question, per_cell);
    struct cells cells = cells_sort(&grid, question->points);
    note_built(question);
    search_indices(question, &grid, &cells, NULL, answers);
    cells_free(&cells);
    grid_free(&grid);
}

//> Sort the points, then search
void cells_sorted(const struct question *question,
                  struct answers *answers)
{
    struct sorted sorted = sorted_make(question, per_cell);
    search_sorted(question, &sorted, answers);
    sorted_free(&sorted);
}
//<
//<
//<

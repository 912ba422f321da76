//> Search point by point
// See point_by_point.h. One search around a point, compiled for each
// way to hold the cells and each geometry.
#include "ch04-cell-sort/point_by_point.h"
#include "ch02-all-pairs/pair.h"
#include "ch04-cell-sort/block.h"
#include "common/clock.h"
#include "common/count.h"
#include <stddef.h>

enum { POINTS_PER_TURN = 256 };

// Chosen by measurement, each for its search.
static const double per_list = 1, per_cell = 1;

//> Hold a point that asks
struct asking {
    double x, y;
    uint32_t self, nearest; // indices
    double best2;
    uint64_t met; // points in the cells that were looked at
};

static inline void meet(struct asking *a, uint32_t j, double distance2)
{
    if (distance2 < a->best2 ||
        (distance2 == a->best2 && j < a->nearest)) {
        a->best2 = distance2;
        a->nearest = j;
    }
}
//<

//> Hold the cells in one of three ways
struct holder {
    const struct grid *grid;
    const struct lists *lists;
    const struct cells *cells;
    struct points points; // in the order of the input, or of the cells
};

// Has a point meet all points of a cell.
typedef void meet_function(const enum geometry geometry,
                           struct space space,
                           const struct holder *holder, uint32_t cell,
                           struct asking *asking);
//<

//> Meet a list
INLINED void meet_list(const enum geometry geometry, struct space space,
                       const struct holder *holder, uint32_t cell,
                       struct asking *asking)
{
    const struct points p = holder->points;
    const uint32_t *next = holder->lists->next;
    uint32_t j = holder->lists->head[cell];
    for (; j != NOBODY; j = next[j]) {
        asking->met++;
        if (j != asking->self)
            meet(asking, j,
                 pair2(geometry, space, p.x[j] - asking->x,
                       p.y[j] - asking->y)
                     .near2);
    }
}
//<

//> Meet a cell through its indices
INLINED void meet_indices(const enum geometry geometry,
                          struct space space,
                          const struct holder *holder, uint32_t cell,
                          struct asking *asking)
{
    const struct points p = holder->points;
    const struct cells *cells = holder->cells;
    uint32_t end = cells->start[cell + 1];
    asking->met += end - cells->start[cell];
    for (uint32_t s = cells->start[cell]; s < end; s++) {
        uint32_t j = cells->point[s];
        if (j != asking->self)
            meet(asking, j,
                 pair2(geometry, space, p.x[j] - asking->x,
                       p.y[j] - asking->y)
                     .near2);
    }
}
//<

//> Meet a cell of sorted points
INLINED void meet_sorted(const enum geometry geometry,
                         struct space space,
                         const struct holder *holder, uint32_t cell,
                         struct asking *asking)
{
    const struct points p = holder->points;
    const struct cells *cells = holder->cells;
    uint32_t end = cells->start[cell + 1];
    asking->met += end - cells->start[cell];
    for (uint32_t s = cells->start[cell]; s < end; s++) {
        uint32_t j = cells->point[s];
        if (j != asking->self)
            meet(asking, j,
                 pair2(geometry, space, p.x[s] - asking->x,
                       p.y[s] - asking->y)
                     .near2);
    }
}
//<

//> Meet the points of a block
INLINED void meet_block(const enum geometry geometry,
                        struct space space, const struct holder *holder,
                        const struct block *block,
                        meet_function *meet_cell, struct asking *asking)
{
    const struct grid *grid = holder->grid;
    asking->met = 0;
    for (uint32_t r = 0; r < block->y.count; r++) {
        uint32_t row = reach_cell(&grid->y, &block->y, r);
        for (uint32_t k = 0; k < block->x.count; k++) {
            uint32_t column = reach_cell(&grid->x, &block->x, k);
            meet_cell(geometry, space, holder,
                      row * grid->x.count + column, asking);
        }
    }
    COUNT(cells, (uint64_t)block->x.count * block->y.count);
    COUNT(distances, asking->met - 1);
}
//<

//> Look at nine cells and no further
INLINED void ask_once(const enum geometry geometry, struct space space,
                      const struct holder *holder,
                      meet_function *meet_cell, struct asking *asking)
{
    struct block block =
        block_of(holder->grid, asking->x, asking->y, 1);
    meet_block(geometry, space, holder, &block, meet_cell, asking);
}
//<

//> Widen the block until it suffices
INLINED void ask(const enum geometry geometry, struct space space,
                 const struct holder *holder, meet_function *meet_cell,
                 struct asking *asking)
{
    const struct grid *grid = holder->grid;
    double margin;
    for (uint32_t radius = 1;; radius *= 2) {
        struct block block =
            block_of(grid, asking->x, asking->y, radius);
        meet_block(geometry, space, holder, &block, meet_cell, asking);
        margin = block_margin(grid, &block, asking->x, asking->y);
        if (asking->best2 < margin * margin ||
            block_covers(grid, &block))
            break;
    }
}
//<

//> Let all points ask
// The order NULL: as the holder has them.
INLINED void search(const enum geometry geometry, const bool test,
                    const struct question *question,
                    const struct holder *holder, const uint32_t *order,
                    const uint32_t *names, meet_function *meet_cell,
                    struct answers *answers)
{
    const struct points p = holder->points;
#pragma omp parallel for num_threads(question->threads) \
    schedule(dynamic, POINTS_PER_TURN)
    for (uint32_t k = 0; k < p.n; k++) {
        uint32_t at = order ? order[k] : k;
        uint32_t i = names ? names[at] : at;
        struct asking asking = {p.x[at], p.y[at],  i,
                                NOBODY,  INFINITY, 0};
        if (test)
            ask(geometry, question->space, holder, meet_cell, &asking);
        else
            ask_once(geometry, question->space, holder, meet_cell,
                     &asking);
        answers->nearest[i] = asking.nearest;
        answers->nearest2[i] = asking.best2;
    }
}

INLINED void search_either(const bool test,
                           const struct question *question,
                           const struct holder *holder,
                           const uint32_t *order, const uint32_t *names,
                           meet_function *meet_cell,
                           struct answers *answers)
{
    if (question->space.geometry == STANDARD)
        search(STANDARD, test, question, holder, order, names,
               meet_cell, answers);
    else
        search(WRAPAROUND, test, question, holder, order, names,
               meet_cell, answers);
}
//<

//> Search in each of three ways
void search_lists(const struct question *question,
                  const struct grid *grid, const struct lists *lists,
                  const uint32_t *order, struct answers *answers)
{
    struct holder holder = {grid, lists, NULL, question->points};
    search_either(true, question, &holder, order, NULL, meet_list,
                  answers);
}

void search_indices(const struct question *question,
                    const struct grid *grid, const struct cells *cells,
                    const uint32_t *order, struct answers *answers)
{
    struct holder holder = {grid, NULL, cells, question->points};
    search_either(true, question, &holder, order, NULL, meet_indices,
                  answers);
}

#ifdef COUNTING
#define search_sorted counting_search_sorted
#endif
void search_sorted(const struct question *question,
                   const struct sorted *sorted, struct answers *answers)
{
    struct holder holder = {&sorted->grid, NULL, &sorted->cells,
                            sorted->points};
    search_either(true, question, &holder, NULL, sorted->cells.point,
                  meet_sorted, answers);
}
//<

//> Search without the test
void search_untested(const struct question *question,
                     const struct sorted *sorted,
                     struct answers *answers)
{
    struct holder holder = {&sorted->grid, NULL, &sorted->cells,
                            sorted->points};
    search_either(false, question, &holder, NULL, sorted->cells.point,
                  meet_sorted, answers);
}
//<

//> Make the structure and search
void cells_lists(const struct question *question,
                 struct answers *answers)
{
    struct grid grid = grid_fit(question, per_list);
    struct lists lists = lists_make(&grid, question->points);
    answers->built_ns = clock_ns();
    search_lists(question, &grid, &lists, NULL, answers);
    lists_free(&lists);
    grid_free(&grid);
}

void cells_indices(const struct question *question,
                   struct answers *answers)
{
    struct grid grid = grid_fit(question, per_cell);
    struct cells cells = cells_sort(&grid, question->points);
    answers->built_ns = clock_ns();
    search_indices(question, &grid, &cells, NULL, answers);
    cells_free(&cells);
    grid_free(&grid);
}

void cells_sorted(const struct question *question,
                  struct answers *answers)
{
    struct sorted sorted =
        sorted_make(question, per_cell, cells_sort_alone);
    answers->built_ns = clock_ns();
    search_sorted(question, &sorted, answers);
    sorted_free(&sorted);
}
//<
//<

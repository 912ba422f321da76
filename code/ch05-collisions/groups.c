//> Sort by groups of lanes
// Lanes write tickets to their cells and read them back: a lane that
// finds its own has won the cell. A group writes from its last lane to
// its first, so that of several lanes with the same cell the first one
// wins, and the order of the points is kept. Every loop over the lanes
// has a form that a vector unit with gather and scatter can do. Losers
// are served one at a time: fast if they are few, right if they are
// many.
#include "ch05-collisions/groups.h"
#include "ch04-cell-sort/batches.h"
#include "common/fail.h"
#include <assert.h>
#include <stdlib.h>

enum { CRAY_LANES = 64 };

struct groups groups_allocate(uint32_t lanes, uint32_t cells)
{
    assert(lanes >= 1 && "a group has a point");
    return (struct groups){lanes, allocate(cells, sizeof(uint32_t)),
                           allocate(lanes, sizeof(uint32_t)),
                           allocate(lanes, sizeof(uint32_t))};
}

void groups_free(struct groups *groups)
{
    free(groups->ticket);
    free(groups->seen);
    free(groups->loser);
    *groups = (struct groups){0};
}

//> Count a group of points
// Returns how many lost.
static uint32_t count_group(const struct groups *g,
                            const uint32_t *cell_id, uint32_t lanes,
                            uint32_t *count)
{
    //> Let every lane write a ticket
    for (uint32_t k = lanes; k-- > 0;)
        g->ticket[cell_id[k]] = k;
    //<
    //> Read the tickets back and pack the losers
    uint32_t losers = 0;
    for (uint32_t k = 0; k < lanes; k++) {
        g->loser[losers] = k;
        losers += g->ticket[cell_id[k]] != k;
    }
    //<
    //> Let all lanes count at once
    for (uint32_t k = 0; k < lanes; k++)
        g->seen[k] = count[cell_id[k]];
    for (uint32_t k = 0; k < lanes; k++)
        count[cell_id[k]] = g->seen[k] + 1;
    //<
    //> Count the losers one by one
    for (uint32_t k = 0; k < losers; k++)
        count[cell_id[g->loser[k]]]++;
    //<
    return losers;
}
//<

//> Place a group of points
// The place that a lane saw serves as its ticket: it is free, and all
// lanes of a cell saw the same one. Returns how many lost.
static uint32_t place_group(const struct groups *g,
                            const uint32_t *cell_id, uint32_t first,
                            uint32_t lanes, uint32_t *next,
                            uint32_t *point)
{
    //> Let every lane write its point to the place it saw
    for (uint32_t k = 0; k < lanes; k++)
        g->seen[k] = next[cell_id[k]];
    for (uint32_t k = lanes; k-- > 0;)
        point[g->seen[k]] = first + k;
    for (uint32_t k = 0; k < lanes; k++)
        next[cell_id[k]] = g->seen[k] + 1;
    //<
    //> Read the places back, then place the losers one by one
    uint32_t losers = 0;
    for (uint32_t k = 0; k < lanes; k++) {
        g->loser[losers] = k;
        losers += point[g->seen[k]] != first + k;
    }
    for (uint32_t k = 0; k < losers; k++)
        point[next[cell_id[g->loser[k]]]++] = first + g->loser[k];
    //<
    return losers;
}
//<

//> Go from group to group
static uint32_t lanes_at(const struct groups *groups, uint32_t i,
                         uint32_t n)
{
    return n - i < groups->lanes ? n - i : groups->lanes;
}

uint64_t groups_count(const struct groups *groups,
                      const uint32_t *cell_id, uint32_t n,
                      uint32_t *count)
{
    uint64_t losers = 0;
    uint32_t lanes;
    for (uint32_t i = 0; i < n; i += lanes) {
        lanes = lanes_at(groups, i, n);
        losers += count_group(groups, cell_id + i, lanes, count);
    }
    return losers;
}
//<

//> Place group after group
uint64_t groups_place(const struct groups *groups,
                      const uint32_t *cell_id, uint32_t n,
                      uint32_t *next, uint32_t *point)
{
    uint64_t losers = 0;
    uint32_t lanes;
    for (uint32_t i = 0; i < n; i += lanes) {
        lanes = lanes_at(groups, i, n);
        losers +=
            place_group(groups, cell_id + i, i, lanes, next, point);
    }
    return losers;
}
//<

//> Sort by groups
struct cells cells_sort_groups(const struct grid *grid,
                               struct points points, uint32_t lanes,
                               struct counts *counts)
{
    const uint32_t n = points.n, m = grid_cells(grid);
    struct counts mine = {0};
    struct groups groups = groups_allocate(lanes, m);
    struct cells cells = cells_allocate(m, n);
    uint32_t *cell_id = allocate(n, sizeof *cell_id);
    uint32_t *count = cells.start + 1;
    find_cell_ids(grid, points, 0, n, cell_id);
    mine.collisions += groups_count(&groups, cell_id, n, count);
    cells_scan(count, m, 0);
    mine.collisions +=
        groups_place(&groups, cell_id, n, count, cells.point);
    counts_add(counts, &mine);
    free(cell_id);
    groups_free(&groups);
    return cells;
}
//<

void cells_groups(const struct question *question,
                  struct answers *answers)
{
    const struct points points = question->points;
    struct sorted sorted = {.grid =
                                grid_fit(question, POINTS_PER_CELL)};
    sorted.cells = cells_sort_groups(&sorted.grid, points, CRAY_LANES,
                                     question->counts);
    sorted.points =
        points_in_order(points, sorted.cells.point, question->threads);
    note_built(question);
    search_batches(question, &sorted, answers);
    sorted_free(&sorted);
}
//<

//> Sort by groups of lanes
// See groups.h. Who reads back what it wrote has won. A group writes
// from its last lane to its first, so that of several lanes with the
// same cell the first one wins, and the order of the points is kept.
#include "ch05-collisions/groups.h"
#include "ch04-cell-sort/together.h"
#include "ch05-collisions/home.h"
#include "common/count.h"
#include "common/fail.h"
#include <assert.h>
#include <stdlib.h>
#include <string.h>

enum { CRAY_LANES = 64 };

struct groups groups_allocate(uint32_t lanes, uint32_t cells)
{
    assert(lanes >= 1 && "somebody counts");
    return (struct groups){lanes, allocate(cells, sizeof(uint32_t)),
                           allocate(lanes, sizeof(uint32_t)),
                           allocate(lanes, sizeof(uint32_t))};
}

void groups_free(struct groups *groups)
{
    free(groups->last);
    free(groups->seen);
    free(groups->lost);
    *groups = (struct groups){0};
}

//> Count a group of points
// Returns how many lost.
static uint32_t count_group(const struct groups *g,
                            const uint32_t *home, uint32_t lanes,
                            uint32_t *count)
{
    //> Let every lane sign its cell
    for (uint32_t k = lanes; k-- > 0;)
        g->last[home[k]] = k;
    uint32_t losers = 0;
    for (uint32_t k = 0; k < lanes; k++) {
        g->lost[losers] = k;
        losers += g->last[home[k]] != k;
    }
    //<
    //> Let all lanes count at once
    for (uint32_t k = 0; k < lanes; k++)
        g->seen[k] = count[home[k]];
    for (uint32_t k = 0; k < lanes; k++)
        count[home[k]] = g->seen[k] + 1;
    //<
    //> Count the losers one by one
    for (uint32_t k = 0; k < losers; k++)
        count[home[g->lost[k]]]++;
    //<
    return losers;
}
//<

//> Place a group of points
// The place that a lane saw serves to sign: it is free, and all lanes
// of a cell saw the same one. Returns how many lost.
static uint32_t place_group(const struct groups *g,
                            const uint32_t *home, uint32_t first,
                            uint32_t lanes, uint32_t *next,
                            uint32_t *point)
{
    for (uint32_t k = 0; k < lanes; k++)
        g->seen[k] = next[home[k]];
    for (uint32_t k = lanes; k-- > 0;)
        point[g->seen[k]] = first + k;
    for (uint32_t k = 0; k < lanes; k++)
        next[home[k]] = g->seen[k] + 1;
    uint32_t losers = 0;
    for (uint32_t k = 0; k < lanes; k++) {
        g->lost[losers] = k;
        losers += point[g->seen[k]] != first + k;
    }
    for (uint32_t k = 0; k < losers; k++)
        point[next[home[g->lost[k]]]++] = first + g->lost[k];
    return losers;
}
//<

//> Go from group to group
static uint32_t lanes_at(const struct groups *groups, uint32_t i,
                         uint32_t n)
{
    return n - i < groups->lanes ? n - i : groups->lanes;
}

uint64_t groups_count(const struct groups *groups, const uint32_t *home,
                      uint32_t n, uint32_t *count)
{
    uint64_t losers = 0;
    uint32_t lanes;
    for (uint32_t i = 0; i < n; i += lanes) {
        lanes = lanes_at(groups, i, n);
        losers += count_group(groups, home + i, lanes, count);
    }
    COUNT(collisions, losers);
    return losers;
}

uint64_t groups_place(const struct groups *groups, const uint32_t *home,
                      uint32_t n, uint32_t *next, uint32_t *point)
{
    uint64_t losers = 0;
    uint32_t lanes;
    for (uint32_t i = 0; i < n; i += lanes) {
        lanes = lanes_at(groups, i, n);
        losers += place_group(groups, home + i, i, lanes, next, point);
    }
    COUNT(collisions, losers);
    return losers;
}
//<

//> Sort by groups
struct cells cells_sort_groups(const struct grid *grid,
                               struct points points, uint32_t lanes)
{
    const uint32_t n = points.n, m = grid_cells(grid);
    struct groups groups = groups_allocate(lanes, m);
    struct cells cells = cells_allocate(m, n);
    uint32_t *home = allocate(n, sizeof *home);
    uint32_t *count = cells.start + 1;
    memset(cells.start, 0, ((size_t)m + 1) * sizeof *cells.start);
    find_homes(grid, points, 0, n, home);
    groups_count(&groups, home, n, count);
    cells_scan(count, m, 0);
    groups_place(&groups, home, n, count, cells.point);
    free(home);
    groups_free(&groups);
    return cells;
}
//<

static struct cells sort_as_a_cray(const struct grid *grid,
                                   struct points points, int threads)
{
    (void)threads;
    return cells_sort_groups(grid, points, CRAY_LANES);
}

void cells_groups(const struct question *question,
                  struct answers *answers)
{
    sort_and_search(question, sort_as_a_cray, answers);
}
//<

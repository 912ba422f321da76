//> Keep a list for every cell
// Each point is put before the list of its cell. n + m steps; a list
// runs from the highest index to the lowest.
#include "ch04-cell-sort/lists.h"
#include "common/allocate.h"
#include <stdlib.h>

//> Put every point before its list
struct lists lists_make(const struct grid *grid, struct points points)
{
    uint32_t m = grid_cells(grid);
    struct lists lists = {allocate(m, sizeof(uint32_t)),
                          allocate(points.n, sizeof(uint32_t))};
    for (uint32_t cell = 0; cell < m; cell++)
        lists.head[cell] = NO_INDEX;
    for (uint32_t i = 0; i < points.n; i++) {
        uint32_t cell = grid_cell(grid, points.x[i], points.y[i]);
        lists.next[i] = lists.head[cell];
        lists.head[cell] = i;
    }
    return lists;
}
//<

void lists_free(struct lists *lists)
{
    free(lists->head);
    free(lists->next);
    *lists = (struct lists){0};
}
//<

//> Sort the points by cell
// See cells.h. Su's figure 2: count the points of every cell, sum the
// counts to the place where each cell begins, put every point in the
// next free place of its cell.
#include "ch04-cell-sort/cells.h"
#include "common/fail.h"
#include <stdlib.h>
#include <string.h>

//> Count the points of every cell
// Writes every point's cell to home[0 .. n-1] and adds to count.
static void histogram(const struct grid *grid, struct points points,
                      uint32_t *home, uint32_t *count)
{
    for (uint32_t i = 0; i < points.n; i++) {
        home[i] = grid_cell(grid, points.x[i], points.y[i]);
        count[home[i]]++;
    }
}
//<

//> Sum the counts to starts
void cells_scan(uint32_t *count, uint32_t m, uint32_t first)
{
    for (uint32_t k = 0; k < m; k++) {
        uint32_t here = count[k];
        count[k] = first;
        first += here;
    }
}
//<

//> Put every point into its place
static void place(const uint32_t *home, uint32_t n, uint32_t *next,
                  uint32_t *point)
{
    for (uint32_t i = 0; i < n; i++)
        point[next[home[i]]++] = i;
}
//<

//> Count, scan, place
// The array of starts serves first as the counts, one place further on:
// placing advances every start to its cell's end, where the next cell
// begins.
struct cells cells_sort(const struct grid *grid, struct points points)
{
    uint32_t m = grid_cells(grid);
    struct cells cells = cells_allocate(m, points.n);
    uint32_t *home = allocate(points.n, sizeof *home);
    uint32_t *count = cells.start + 1;
    memset(cells.start, 0, ((size_t)m + 1) * sizeof *cells.start);
    histogram(grid, points, home, count);
    cells_scan(count, m, 0);
    place(home, points.n, count, cells.point);
    free(home);
    return cells;
}
//<

struct cells cells_allocate(uint32_t m, uint32_t n)
{
    return (struct cells){allocate((size_t)m + 1, sizeof(uint32_t)),
                          allocate(n, sizeof(uint32_t))};
}

void cells_free(struct cells *cells)
{
    free(cells->start);
    free(cells->point);
    *cells = (struct cells){0};
}
//<

//> Sort with counts for all threads
// See shared.h.
#include "ch05-collisions/shared.h"
#include "ch05-collisions/home.h"
#include "common/fail.h"
#include <stdlib.h>
#include <string.h>

//> Count and place atomically
struct cells cells_sort_atomic(const struct grid *grid,
                               struct points points, int threads)
{
    const uint32_t n = points.n, m = grid_cells(grid);
    struct cells cells = cells_allocate(m, n);
    uint32_t *home = allocate(n, sizeof *home);
    uint32_t *count = cells.start + 1;
    memset(cells.start, 0, ((size_t)m + 1) * sizeof *cells.start);
#pragma omp parallel for num_threads(threads)
    for (int k = 0; k < threads; k++) {
        uint32_t i = share_begin(n, k, threads);
        uint32_t end = share_begin(n, k + 1, threads);
        find_homes(grid, points, i, end, home);
        //> Count one point at a time
        for (; i < end; i++) {
#pragma omp atomic
            count[home[i]]++;
        }
        //<
    }
    cells_scan(count, m, 0);
    //> Take a place at a time
#pragma omp parallel for num_threads(threads)
    for (uint32_t i = 0; i < n; i++) {
        uint32_t place;
#pragma omp atomic capture
        place = count[home[i]]++;
        cells.point[place] = i;
    }
    //<
    free(home);
    return cells;
}
//<

//> Count the points of every band
void count_shares(const struct grid *grid, struct points points,
                  int shares, int shift, uint32_t m, uint32_t *home,
                  uint32_t *count)
{
#pragma omp parallel for num_threads(shares)
    for (int k = 0; k < shares; k++) {
        uint32_t *mine = count + (size_t)k * m;
        uint32_t i = share_begin(points.n, k, shares);
        uint32_t end = share_begin(points.n, k + 1, shares);
        memset(mine, 0, m * sizeof *mine);
        find_homes(grid, points, i, end, home);
        for (; i < end; i++)
            mine[home[i] >> shift]++;
    }
}
//<

//> Scan over cells and threads
// All of a cell's points before those of the next cell, and of these
// the first thread's before the next one's.
void scan_shares(uint32_t *count, uint32_t m, int shares,
                 uint32_t *start)
{
    uint32_t sum = 0;
    for (uint32_t cell = 0; cell < m; cell++) {
        start[cell] = sum;
        for (int k = 0; k < shares; k++) {
            uint32_t *mine = &count[(size_t)k * m + cell];
            uint32_t here = *mine;
            *mine = sum;
            sum += here;
        }
    }
    start[m] = sum;
}
//<

//> Count and place privately
struct cells cells_sort_private(const struct grid *grid,
                                struct points points, int threads)
{
    const uint32_t n = points.n, m = grid_cells(grid);
    struct cells cells = cells_allocate(m, n);
    uint32_t *home = allocate(n, sizeof *home);
    uint32_t *count = allocate((size_t)threads * m, sizeof *count);
    count_shares(grid, points, threads, 0, m, home, count);
    scan_shares(count, m, threads, cells.start);
#pragma omp parallel for num_threads(threads)
    for (int k = 0; k < threads; k++) {
        uint32_t *next = count + (size_t)k * m;
        uint32_t i = share_begin(n, k, threads);
        uint32_t end = share_begin(n, k + 1, threads);
        for (; i < end; i++)
            cells.point[next[home[i]]++] = i;
    }
    free(count);
    free(home);
    return cells;
}
//<
//<

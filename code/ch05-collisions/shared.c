//> Sort with counts for all threads
// Either all threads increment the same counts, atomically; or each has
// counts of its own for a chunk of the points, and a scan over cells
// and chunks tells each where its points go. The second keeps the order
// of the points and costs m counts a thread.
#include "ch05-collisions/shared.h"
#include "common/allocate.h"
#include "common/chunk.h"
#include <stdlib.h>
#include <string.h>

//> Count and place atomically
struct cells cells_sort_atomic(const struct grid *grid,
                               struct points points, int threads)
{
    const uint32_t n = points.n, m = grid_cells(grid);
    struct cells cells = cells_allocate(m, n);
    uint32_t *cell_id = allocate(n, sizeof *cell_id);
    uint32_t *count = cells.start + 1;
#pragma omp parallel for num_threads(threads)
    for (int k = 0; k < threads; k++) {
        uint32_t i = chunk_begin(n, k, threads);
        uint32_t end = chunk_begin(n, k + 1, threads);
        find_cell_ids(grid, points, i, end, cell_id + i);
        //> Count one point at a time
        for (; i < end; i++) {
#pragma omp atomic
            count[cell_id[i]]++;
        }
        //<
    }
    cells_scan(count, m, 0);
    //> Take a place at a time
#pragma omp parallel for num_threads(threads)
    for (uint32_t i = 0; i < n; i++) {
        uint32_t place;
#pragma omp atomic capture
        place = count[cell_id[i]]++;
        cells.point[place] = i;
    }
    //<
    free(cell_id);
    return cells;
}
//<

//> Count in chunks
// Count[k * m + cell] is how many of chunk k's points are in a cell.
static void count_chunks(const struct grid *grid, struct points points,
                         int chunks, uint32_t *cell_id, uint32_t *count)
{
    const uint32_t m = grid_cells(grid);
#pragma omp parallel for num_threads(chunks)
    for (int k = 0; k < chunks; k++) {
        uint32_t *mine = count + (size_t)k * m;
        uint32_t i = chunk_begin(points.n, k, chunks);
        uint32_t end = chunk_begin(points.n, k + 1, chunks);
        memset(mine, 0, m * sizeof *mine);
        find_cell_ids(grid, points, i, end, cell_id + i);
        for (; i < end; i++)
            mine[cell_id[i]]++;
    }
}
//<

//> Scan over cells and threads
// All of a cell's points before those of the next cell, and in a cell
// the first chunk's before the second's.
void scan_chunks(uint32_t *count, uint32_t m, int chunks,
                 uint32_t *start)
{
    uint32_t sum = 0;
    for (uint32_t cell = 0; cell < m; cell++) {
        start[cell] = sum;
        for (int k = 0; k < chunks; k++) {
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
    uint32_t *cell_id = allocate(n, sizeof *cell_id);
    uint32_t *count = allocate((size_t)threads * m, sizeof *count);
    count_chunks(grid, points, threads, cell_id, count);
    scan_chunks(count, m, threads, cells.start);
#pragma omp parallel for num_threads(threads)
    for (int k = 0; k < threads; k++) {
        uint32_t *next = count + (size_t)k * m;
        uint32_t i = chunk_begin(n, k, threads);
        uint32_t end = chunk_begin(n, k + 1, threads);
        for (; i < end; i++)
            cells.point[next[cell_id[i]]++] = i;
    }
    free(count);
    free(cell_id);
    return cells;
}
//<
//<

//> Sort by bands of cells
// See bands.h.
#include "ch05-collisions/bands.h"
#include "ch04-cell-sort/together.h"
#include "ch05-collisions/home.h"
#include "ch05-collisions/shared.h"
#include "common/fail.h"
#include <stdlib.h>
#include <string.h>

//> Choose the width of a band
// Band b holds the cells from b << shift on. The counts of 2^14 cells
// are 64 KB, which a second-level cache has to spare; a small grid is
// cut into at least so many bands, for the threads to share.
enum { WIDEST_SHIFT = 14, FEWEST_BANDS = 64 };

static int band_shift(uint32_t m)
{
    int shift = WIDEST_SHIFT;
    while (shift > 0 && m >> shift < FEWEST_BANDS)
        shift--;
    return shift;
}
//<

// A point on its way.
struct item {
    uint32_t cell, point;
};

//> Send every point to its band
// Takes places from next, as scan_shares left it.
static void send(const uint32_t *home, uint32_t n, int shares,
                 int shift, uint32_t bands, uint32_t *next,
                 struct item *item)
{
#pragma omp parallel for num_threads(shares)
    for (int k = 0; k < shares; k++) {
        uint32_t *mine = next + (size_t)k * bands;
        uint32_t i = share_begin(n, k, shares);
        uint32_t end = share_begin(n, k + 1, shares);
        for (; i < end; i++)
            item[mine[home[i] >> shift]++] = (struct item){home[i], i};
    }
}
//<

//> Sort a band
// The items begin .. end - 1, all in the cells first .. last - 1.
static void sort_band(const struct item *item, uint32_t begin,
                      uint32_t end, uint32_t first, uint32_t last,
                      struct cells *cells)
{
    uint32_t *count = cells->start + 1;
    memset(count + first, 0, (last - first) * sizeof *count);
    for (uint32_t s = begin; s < end; s++)
        count[item[s].cell]++;
    cells_scan(count + first, last - first, begin);
    for (uint32_t s = begin; s < end; s++)
        cells->point[count[item[s].cell]++] = item[s].point;
}
//<

//> Sort by band, then by cell
struct cells cells_sort_threads(const struct grid *grid,
                                struct points points, int threads)
{
    const uint32_t n = points.n, m = grid_cells(grid);
    const int shift = band_shift(m);
    const uint32_t bands = ((m - 1) >> shift) + 1;
    struct cells cells = cells_allocate(m, n);
    struct item *item = allocate(n, sizeof *item);
    uint32_t *home = allocate(n, sizeof *home);
    uint32_t *begin = allocate(bands + 1, sizeof *begin);
    uint32_t *next = allocate((size_t)threads * bands, sizeof *next);
    count_shares(grid, points, threads, shift, bands, home, next);
    scan_shares(next, bands, threads, begin);
    send(home, n, threads, shift, bands, next, item);
    //> Let one thread sort each band
    cells.start[0] = 0;
#pragma omp parallel for num_threads(threads) schedule(dynamic)
    for (uint32_t b = 0; b < bands; b++) {
        uint32_t first = b << shift;
        uint32_t last = b + 1 < bands ? (b + 1) << shift : m;
        sort_band(item, begin[b], begin[b + 1], first, last, &cells);
    }
    //<
    free(next);
    free(begin);
    free(home);
    free(item);
    return cells;
}
//<

void cells_threads(const struct question *question,
                   struct answers *answers)
{
    sort_and_search(question, cells_sort_threads, answers);
}
//<

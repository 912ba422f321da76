//> Sort, and carry the points
// See carry.h. Everything is written in streams or into a cache.
#include "ch09-row-spans/carry.h"
#include "ch05-collisions/home.h"
#include "ch05-collisions/shared.h"
#include "common/fail.h"
#include <stdlib.h>
#include <string.h>

//> Choose a band that fits the cache
// The points of 2^12 cells, coming and going, are some 300 KB if there
// are 1.5 in each. A small grid is cut into at least so many bands, for
// the threads to share.
enum { WIDEST_SHIFT = 12, FEWEST_BANDS = 128, STRIP = 512 };

static int band_shift(uint32_t m)
{
    int shift = WIDEST_SHIFT;
    while (shift > 0 && m >> shift < FEWEST_BANDS)
        shift--;
    return shift;
}
//<

//> Pack a point for the way
struct parcel {
    double x, y;
    uint32_t cell, point;
};
//<

// What all threads work on.
struct load {
    const struct grid *grid;
    struct points points;
    int shares, shift;
    uint32_t bands;
    uint32_t *next; // next[share * bands + band]
    uint32_t *sent; // in which parcel
};

//> Find the homes of a strip
// Of the points i and following, at most STRIP and before end.
static uint32_t strip_homes(const struct load *load, uint32_t i,
                            uint32_t end, uint32_t *home)
{
    struct points strip = {end - i < STRIP ? end - i : STRIP,
                           load->points.x + i, load->points.y + i};
    find_homes(load->grid, strip, 0, strip.n, home);
    return strip.n;
}
//<

//> Count for every band
// The homes are computed anew when they are needed again: that is
// cheaper than to write them down.
static void count_bands(const struct load *load)
{
#pragma omp parallel for num_threads(load->shares)
    for (int k = 0; k < load->shares; k++) {
        uint32_t *mine = load->next + (size_t)k * load->bands;
        uint32_t i = share_begin(load->points.n, k, load->shares);
        uint32_t end = share_begin(load->points.n, k + 1, load->shares);
        uint32_t home[STRIP], count;
        memset(mine, 0, load->bands * sizeof *mine);
        for (; i < end; i += count) {
            count = strip_homes(load, i, end, home);
            for (uint32_t s = 0; s < count; s++)
                mine[home[s] >> load->shift]++;
        }
    }
}
//<

//> Send every point, with all it has
static void send(const struct load *load, struct parcel *parcel)
{
    const struct points p = load->points;
#pragma omp parallel for num_threads(load->shares)
    for (int k = 0; k < load->shares; k++) {
        uint32_t *mine = load->next + (size_t)k * load->bands;
        uint32_t i = share_begin(p.n, k, load->shares);
        uint32_t end = share_begin(p.n, k + 1, load->shares);
        uint32_t home[STRIP], count;
        for (; i < end; i += count) {
            count = strip_homes(load, i, end, home);
            for (uint32_t s = 0; s < count; s++) {
                uint32_t at = mine[home[s] >> load->shift]++;
                parcel[at] = (struct parcel){p.x[i + s], p.y[i + s],
                                             home[s], i + s};
                load->sent[i + s] = at;
            }
        }
    }
}
//<

//> Unpack a band
// The parcels begin .. end - 1, all for the cells first .. last - 1.
static void unpack(const struct parcel *parcel, uint32_t begin,
                   uint32_t end, uint32_t first, uint32_t last,
                   struct carried *carried)
{
    struct sorted *sorted = &carried->sorted;
    uint32_t *count = sorted->cells.start + 1;
    memset(count + first, 0, (last - first) * sizeof *count);
    for (uint32_t s = begin; s < end; s++)
        count[parcel[s].cell]++;
    cells_scan(count + first, last - first, begin);
    for (uint32_t s = begin; s < end; s++) {
        uint32_t place = count[parcel[s].cell]++;
        sorted->points.x[place] = parcel[s].x;
        sorted->points.y[place] = parcel[s].y;
        sorted->cells.point[place] = parcel[s].point;
        carried->came[place] = s;
    }
}
//<

//> Send to bands, unpack band by band
static void carry(const struct load *load, struct carried *carried)
{
    const uint32_t m = grid_cells(load->grid);
    struct parcel *parcel = allocate(load->points.n, sizeof *parcel);
    uint32_t *begin = allocate(load->bands + 1, sizeof *begin);
    count_bands(load);
    scan_shares(load->next, load->bands, load->shares, begin);
    send(load, parcel);
    carried->sorted.cells.start[0] = 0;
#pragma omp parallel for num_threads(load->shares) schedule(dynamic)
    for (uint32_t b = 0; b < load->bands; b++) {
        uint32_t first = b << load->shift;
        uint32_t last =
            b + 1 < load->bands ? (b + 1) << load->shift : m;
        unpack(parcel, begin[b], begin[b + 1], first, last, carried);
    }
    free(begin);
    free(parcel);
}

struct carried carry_points(const struct question *question, double c)
{
    const struct points points = question->points;
    struct carried carried = {
        .sorted = {.grid = grid_fit(question, c)},
        .sent = allocate(points.n, sizeof *carried.sent),
        .came = allocate(points.n, sizeof *carried.came)};
    const uint32_t m = grid_cells(&carried.sorted.grid);
    struct load load = {.grid = &carried.sorted.grid,
                        .points = points,
                        .shares = question->threads,
                        .shift = band_shift(m),
                        .sent = carried.sent};
    load.bands = ((m - 1) >> load.shift) + 1;
    load.next =
        allocate((size_t)load.shares * load.bands, sizeof *load.next);
    carried.sorted.cells = cells_allocate(m, points.n);
    carried.sorted.points = points_allocate(points.n);
    carry(&load, &carried);
    free(load.next);
    return carried;
}

void carried_free(struct carried *carried)
{
    sorted_free(&carried->sorted);
    free(carried->sent);
    free(carried->came);
    *carried = (struct carried){0};
}
//<
//<

//> Search with eight queries at a time
// A tile of eight queries stays in vector registers while every
// candidate is copied into all lanes and compared with each. Around the
// tile itself a plain loop with a test takes over. `fused` has the
// multipliers subtract; bitwise the same.
#include "ch02-all-pairs/tiles.h"
#include "ch02-all-pairs/subtract_fused.h"
#include "ch02-all-pairs/tile.h"
#include <assert.h>

//> Sweep with a tile
INLINED void sweep(const enum geometry geometry, const bool fused,
                   const struct question *question, uint64_t begin,
                   uint64_t end, struct tile *tile)
{
    if (begin >= end)
        return;
    const double *x = question->points.x, *y = question->points.y;
    const struct space space = question->space;
    const double one = unit;
    struct tile t = *tile; // a copy, so that it may live in registers
    //> Compare a candidate with eight queries
    for (uint64_t j = begin; j < end; j++) {
#pragma omp simd
        for (int lane = 0; lane < LANES; lane++) {
            double dx = fused ? subtract_fused(x[j], t.x[lane], one)
                              : x[j] - t.x[lane];
            double dy = fused ? subtract_fused(y[j], t.y[lane], one)
                              : y[j] - t.y[lane];
            struct pair_distances pair = pair2(geometry, space, dx, dy);
            t.near2[lane] = MIN(pair.near2, t.near2[lane]);
            t.far2[lane] = MAX(pair.far2, t.far2[lane]);
        }
    }
    //<
    t.distances += (end - begin) * LANES;
    *tile = t;
}
//<

//> Compare the points of a tile with each other
INLINED void compare_within(const enum geometry geometry,
                            const struct question *question, uint32_t i,
                            int width, struct tile *tile)
{
    const struct points p = question->points;
    for (int lane = 0; lane < width; lane++)
        for (uint32_t j = i; j < i + width; j++) {
            if (j == i + lane)
                continue;
            struct pair_distances pair =
                pair2(geometry, question->space, p.x[j] - tile->x[lane],
                      p.y[j] - tile->y[lane]);
            tile->near2[lane] = MIN(pair.near2, tile->near2[lane]);
            tile->far2[lane] = MAX(pair.far2, tile->far2[lane]);
        }
    tile->distances += width * (width - 1);
}
//<

//> Answer for one tile
struct row_range { // at most LANES queries, and the size of a block
    uint32_t begin, end, block;
};

INLINED void search(const enum geometry geometry, const bool fused,
                    const struct question *question,
                    struct answers *answers,
                    const struct row_range rows)
{
    const struct points p = question->points;
    const uint32_t i = rows.begin, size = rows.block;
    const int width = MIN(LANES, rows.end - i);
    struct tile tile;
    struct blocks found;
    tile_begin(&tile, &found);
    // spare lanes repeat the last query
    for (int lane = 0; lane < LANES; lane++) {
        tile.x[lane] = p.x[i + MIN(lane, width - 1)];
        tile.y[lane] = p.y[i + MIN(lane, width - 1)];
    }
    for (uint64_t block = 0; block < p.n; block += size) {
        uint64_t stop = MIN(p.n, block + size);
        //> Sweep a block around the tile
        struct tile before = tile;
        sweep(geometry, fused, question, block, MIN(stop, i), &tile);
        if (block <= i && i < stop)
            compare_within(geometry, question, i, width, &tile);
        sweep(geometry, fused, question, MAX(block, i + width), stop,
              &tile);
        tile_note(&before, &tile, block, &found);
        //<
    }
    for (int lane = 0; lane < width; lane++)
        tile.distances += tile_answer(
            geometry, question, answers, i + lane,
            (struct winner){tile.near2[lane], tile.far2[lane],
                            found.near[lane], found.far[lane]});
    counts_add(question->counts,
               &(struct counts){.distances = tile.distances});
}
//<

//> Go from tile to tile
INLINED void queries(const enum geometry geometry,
                     const struct question *question,
                     struct answers *answers, uint32_t begin,
                     uint32_t end)
{
    assert(begin % LANES == 0 && "a tile must lie in one block");
    for (uint64_t i = begin; i < end; i += LANES)
        search(geometry, false, question, answers,
               (struct row_range){i, end, BLOCK});
}

SPECIALIZE(queries)
//<

//> Answer with blocks of any size
void tiles_blocked_rows(const struct question *question,
                        struct answers *answers, uint32_t begin,
                        uint32_t end, uint32_t block)
{
    assert(begin % LANES == 0 && block % LANES == 0);
    for (uint64_t i = begin; i < end; i += LANES)
        IN_GEOMETRY(question->space, search, true, question, answers,
                    (struct row_range){i, end, block});
}

void tiles_rows(const struct question *question,
                struct answers *answers, uint32_t begin, uint32_t end)
{
    tiles_blocked_rows(question, answers, begin, end, BLOCK);
}
//<

//> Share out the tiles among threads
void tiles(const struct question *question, struct answers *answers)
{
    uint32_t n = question->points.n;
    uint32_t count = n / LANES + (n % LANES != 0);
#pragma omp parallel for num_threads(question->threads) schedule(static)
    for (uint32_t tile = 0; tile < count; tile++) {
        uint64_t begin = (uint64_t)tile * LANES;
        tiles_rows(question, answers, begin, MIN(n, begin + LANES));
    }
}
//<
//<

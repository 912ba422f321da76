//> Walk down the triangle in tiles
// The triangle is cut into tiles: a block of rows against a block of
// columns. The columns, coordinates and bests so far, stay in the first
// cache while the rows pass over them, several columns at a time. As in
// chapter 2, the bests learn only the block of a neighbor, and a second
// look finds the point.
#include "ch03-half-pairs/triangle_tiles.h"
#include "ch02-all-pairs/subtract_fused.h"
#include "ch02-all-pairs/tile.h"
#include "ch03-half-pairs/best.h"

//> Fix the sizes of a tile
enum { SIDE = 256 }; // a multiple of LANES

struct tile_columns {
    double x[SIDE], y[SIDE];
    double near2[SIDE], far2[SIDE]; // the best so far
};
//<

//> Load the columns of a tile
// Beyond the last point stands NAN: no distance to it is smaller or
// greater than another.
static void load(struct tile_columns *columns, struct points points,
                 uint64_t left)
{
    for (uint32_t k = 0; k < SIDE; k++) {
        bool inside = k < points.n - left;
        columns->x[k] = inside ? points.x[left + k] : NAN;
        columns->y[k] = inside ? points.y[left + k] : NAN;
        columns->near2[k] = INFINITY;
        columns->far2[k] = 0;
    }
}
//<

//> Measure a row of the tile
// Returns the best of the row at (x, y); those of the columns are
// improved. Each lane has a best of its own, so that no step waits for
// the last. The columns' arrays have pointers of their own: gcc keeps
// low and high in registers only if nothing else may be where they are.
INLINED struct pair_distances measure(const enum geometry geometry,
                                      struct space space, double x,
                                      double y,
                                      struct tile_columns *columns)
{
    const double *restrict xs = columns->x;
    const double *restrict ys = columns->y;
    double *restrict near2 = columns->near2;
    double *restrict far2 = columns->far2;
    const double one = unit;
    double low[LANES], high[LANES];
    for (int lane = 0; lane < LANES; lane++) {
        low[lane] = INFINITY;
        high[lane] = 0;
    }
    for (int k = 0; k < SIDE; k += LANES)
#pragma omp simd
        for (int lane = 0; lane < LANES; lane++) {
            double dx = subtract_fused(xs[k + lane], x, one);
            double dy = subtract_fused(ys[k + lane], y, one);
            struct pair_distances pair = pair2(geometry, space, dx, dy);
            //> Improve both ends without a branch
            low[lane] = MIN(pair.near2, low[lane]);
            high[lane] = MAX(pair.far2, high[lane]);
            near2[k + lane] = MIN(pair.near2, near2[k + lane]);
            far2[k + lane] = MAX(pair.far2, far2[k + lane]);
            //<
        }
    //> Fold the lanes into one
    for (int half = LANES / 2; half > 0; half /= 2)
        for (int lane = 0; lane < half; lane++) {
            low[lane] = MIN(low[lane], low[lane + half]);
            high[lane] = MAX(high[lane], high[lane + half]);
        }
    return (struct pair_distances){low[0], high[0]};
    //<
}
//<

//> Measure a tile
// Returns how many pairs it has.
INLINED uint64_t tile(const enum geometry geometry,
                      const struct question *question,
                      struct bests bests, uint64_t top, uint64_t left)
{
    const struct points p = question->points;
    struct tile_columns columns;
    load(&columns, p, left);
    const uint64_t right = MIN(left + SIDE, p.n);
    uint64_t pairs = 0;
    //> Pass the rows over the columns
    for (uint64_t i = top; i < top + SIDE && i < p.n; i++) {
        if (top == left) // compare only with the points after i
            columns.x[i - top] = NAN;
        struct pair_distances best = measure(geometry, question->space,
                                             p.x[i], p.y[i], &columns);
        offer_atomic(&bests.near[i], best.near2, left / SIDE);
        offer_atomic(&bests.far[i], -best.far2, left / SIDE);
        pairs += right - (top == left ? i + 1 : left);
    }
    //<
    //> Offer the bests of the columns
    for (uint64_t j = left; j < right; j++) {
        offer_atomic(&bests.near[j], columns.near2[j - left],
                     top / SIDE);
        offer_atomic(&bests.far[j], -columns.far2[j - left],
                     top / SIDE);
    }
    //<
    return pairs;
}
//<

//> Share the tiles, then the points
INLINED void share(const enum geometry geometry,
                   const struct question *question, struct bests bests,
                   struct answers *answers)
{
    const uint32_t n = question->points.n;
    struct counts mine = {0};
#pragma omp for schedule(dynamic, 1)
    for (uint64_t top = 0; top < n; top += SIDE) {
        for (uint64_t left = top; left < n; left += SIDE)
            mine.distances +=
                tile(geometry, question, bests, top, left);
    }
#pragma omp for
    for (uint32_t i = 0; i < n; i++)
        mine.distances += tile_answer(
            geometry, question, answers, i,
            (struct winner){bests.near[i].key, -bests.far[i].key,
                            bests.near[i].index * (uint64_t)SIDE,
                            bests.far[i].index * (uint64_t)SIDE});
    counts_add(question->counts, &mine);
}
//<

//> Search in tiles of the triangle
void triangle_tiles(const struct question *question,
                    struct answers *answers)
{
    struct bests bests = bests_begin(question->points.n);
#pragma omp parallel num_threads(question->threads)
    IN_GEOMETRY(question->space, share, question, bests, answers);
    bests_free(&bests);
}
//<
//<

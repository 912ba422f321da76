//> Take a census
// See census.h.
#include "ch07-spiral/census.h"
#include "ch07-spiral/seek.h"

//> Count what all searches look at
INLINED void count_all(const enum geometry geometry,
                       const struct map *map, int threads,
                       struct census *census)
{
    uint64_t met = 0, looked = 0;
#pragma omp parallel for num_threads(threads) schedule(dynamic, 256) \
    reduction(+ : met, looked)
    for (uint32_t i = 0; i < map->points.n; i++) {
        struct seeker seeker = seeker_at(map->points, i);
        seek(geometry, map, look_at_cell, &seeker);
        met += seeker.met;
        looked += seeker.looked;
    }
    census->distances = (double)met / map->points.n;
    census->cells = (double)looked / map->points.n;
}
//<

struct census take_census(const struct question *question, double c)
{
    struct grid grid = grid_fit(question, c);
    struct cells cells = cells_sort(&grid, question->points);
    struct map map = {&grid, &cells, question->points, question->space};
    struct census census = {(double)map.points.n / grid_cells(&grid), 0,
                            0};
    if (question->space.geometry == STANDARD)
        count_all(STANDARD, &map, question->threads, &census);
    else
        count_all(WRAPAROUND, &map, question->threads, &census);
    cells_free(&cells);
    grid_free(&grid);
    return census;
}
//<

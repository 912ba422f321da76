// Counts what the spiral searches of all points visit; see census.h.
#include "ch07-spiral/experiments/census.h"
#include "ch07-spiral/two_phases.h"
#include "common/experiment.h"

INLINED void count_all(const enum geometry geometry,
                       const struct map *map, int threads,
                       struct census *census)
{
    uint64_t distances = 0, visited = 0;
#pragma omp parallel for num_threads(threads) schedule(dynamic, 256) \
    reduction(+ : distances, visited)
    for (uint32_t i = 0; i < map->points.n; i++) {
        struct spiral_query query = spiral_query_at(map, i);
        spiral_nearest(geometry, map, visit_cell, &query);
        distances += query.distances;
        visited += query.cells;
    }
    census->distances = (double)distances / map->points.n;
    census->cells = (double)visited / map->points.n;
}

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

//> Search in spirals
// The nearest neighbors of all points by spiral search, through the
// points sorted by cell, as indices. Threads share out the points; no
// two write to the same place.
#include "ch07-spiral/spiral.h"
#include "ch07-spiral/spiral_search.h"
#include <stddef.h>

enum { POINTS_PER_CHUNK = 256 };

// The valley is wide; this is what the report has.
static const double per_cell = 1;

//> Search for every point
INLINED void search(const enum geometry geometry, const struct map *map,
                    const struct question *question,
                    const uint32_t *order, struct answers *answers)
{
#pragma omp parallel num_threads(question->threads)
    {
        struct counts mine = {0};
#pragma omp for schedule(dynamic, POINTS_PER_CHUNK)
        for (uint32_t k = 0; k < map->points.n; k++) {
            uint32_t i = order ? order[k] : k;
            struct spiral_query query = spiral_query_at(map, i);
            spiral_nearest(geometry, map, visit_cell, &query);
            answers->nearest[i] = query.nearest;
            answers->nearest2[i] = query.best2;
            mine.cells += query.cells;
            mine.distances += query.distances;
        }
        counts_add(question->counts, &mine);
    }
}
//<

//> Choose the copy of the geometry
void search_spiral(const struct question *question,
                   const struct grid *grid, const struct cells *cells,
                   const uint32_t *order, struct answers *answers)
{
    struct map map = {grid, cells, question->points, question->space};
    if (question->space.geometry == STANDARD)
        search(STANDARD, &map, question, order, answers);
    else
        search(WRAPAROUND, &map, question, order, answers);
}
//<

//> Sort, then search in spirals
void spiral(const struct question *question, struct answers *answers)
{
    struct grid grid = grid_fit(question, per_cell);
    struct cells cells = cells_sort(&grid, question->points);
    note_built(question);
    search_spiral(question, &grid, &cells, NULL, answers);
    cells_free(&cells);
    grid_free(&grid);
}
//<
//<

//> Search in spirals
// See spiral.h.
#include "ch07-spiral/spiral.h"
#include "ch07-spiral/seek.h"
#include "common/clock.h"
#include "common/count.h"
#include <stddef.h>

enum { POINTS_PER_TURN = 256 };

// The valley is wide; this is what the report has.
static const double per_cell = 1;

//> Let every point seek
INLINED void search(const enum geometry geometry, const struct map *map,
                    const uint32_t *order, int threads,
                    struct answers *answers)
{
#pragma omp parallel for num_threads(threads) \
    schedule(dynamic, POINTS_PER_TURN)
    for (uint32_t k = 0; k < map->points.n; k++) {
        uint32_t i = order ? order[k] : k;
        struct seeker seeker = seeker_at(map->points, i);
        seek(geometry, map, look_at_cell, &seeker);
        answers->nearest[i] = seeker.nearest;
        answers->nearest2[i] = seeker.best2;
        COUNT(cells, seeker.looked);
        COUNT(distances, seeker.met);
    }
}
//<

void search_spiral(const struct question *question,
                   const struct grid *grid, const struct cells *cells,
                   const uint32_t *order, struct answers *answers)
{
    struct map map = {grid, cells, question->points, question->space};
    if (question->space.geometry == STANDARD)
        search(STANDARD, &map, order, question->threads, answers);
    else
        search(WRAPAROUND, &map, order, question->threads, answers);
}

//> Sort, then seek
void spiral(const struct question *question, struct answers *answers)
{
    struct grid grid = grid_fit(question, per_cell);
    struct cells cells = cells_sort(&grid, question->points);
    answers->built_ns = clock_ns();
    search_spiral(question, &grid, &cells, NULL, answers);
    cells_free(&cells);
    grid_free(&grid);
}
//<
//<

//> Look the furthest up
// For every point its cell, and for that its only candidate or the
// furthest of a few, in strips of points that share the arithmetic of
// their cells. Points come in the order of the input, and so do their
// answers. About one distance a point if the points are spread evenly.
#include "ch10-furthest/candidate_search.h"

//> Find the candidate cells of a strip
// A point that rounding puts outside of the grid is in the cell beside.
enum { STRIP = 512 };

static inline uint32_t cell_on(double x, double low, double scale,
                               double side)
{
    double at = (x - low) * scale;
    at = at > 0 ? at : 0;
    return (uint32_t)(int32_t)(at < side ? at : side - 1);
}
//<

//> Compare the corners of a list
static uint32_t furthest_of(struct points corners, const uint32_t *list,
                            double x, double y)
{
    const uint32_t count = list[0];
    double max2 = -1;
    uint32_t far = list[1];
    for (uint32_t k = 1; k <= count; k++) {
        double d2 =
            distance2(corners.x[list[k]] - x, corners.y[list[k]] - y);
        if (d2 > max2) // of a tie the first has the lowest index
            max2 = d2, far = list[k];
    }
    return far;
}
//<

//> Search a strip
static void search_strip(const struct question *question,
                         const struct corners *corners,
                         const struct candidate_grid *grid,
                         uint32_t begin, struct answers *answers)
{
    const struct points p = question->points, c = corners->points;
    const uint32_t left = p.n - begin;
    const struct points strip = {left < STRIP ? left : STRIP,
                                 p.x + begin, p.y + begin};
    uint32_t *furthest = answers->furthest + begin;
    double *furthest2 = answers->furthest2 + begin;
    uint32_t cell[STRIP];
    uint64_t distances = strip.n;
    const struct candidate_grid g = *grid;
    for (uint32_t i = 0; i < strip.n; i++)
        cell[i] = cell_on(strip.y[i], g.bottom, g.up, g.side) * g.side +
                  cell_on(strip.x[i], g.left, g.across, g.side);
    for (uint32_t i = 0; i < strip.n; i++) {
        double x = strip.x[i], y = strip.y[i];
        uint32_t far = grid->cell[cell[i]];
        if (far >= c.n) {
            const uint32_t *list = grid->list + (far - c.n);
            far = furthest_of(c, list, x, y);
            distances += list[0];
        }
        furthest[i] = corners->point[far];
        furthest2[i] = distance2(c.x[far] - x, c.y[far] - y);
        if (furthest2[i] == 0) // so are all
            furthest[i] = begin + i == 0;
    }
    counts_add(question->counts,
               &(struct counts){.distances = distances});
}
//<

void search_candidate_grid(const struct question *question,
                           const struct corners *corners,
                           const struct candidate_grid *grid,
                           struct answers *answers)
{
    const uint32_t strips = (question->points.n - 1) / STRIP + 1;
#pragma omp parallel for num_threads(question->threads) \
    schedule(dynamic)
    for (uint32_t k = 0; k < strips; k++)
        search_strip(question, corners, grid, k * STRIP, answers);
}
//<

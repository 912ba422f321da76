//> Keep the points sorted by cell
// Fit a grid, sort the indices by cell, copy the points in this order:
// a search then reads memory from left to right. 16 n more bytes.
#include "ch04-cell-sort/sorted.h"

//> Copy the points in order
struct points points_in_order(struct points points,
                              const uint32_t *order, int threads)
{
    struct points sorted = points_allocate(points.n);
#pragma omp parallel for num_threads(threads)
    for (uint32_t s = 0; s < points.n; s++) {
        sorted.x[s] = points.x[order[s]];
        sorted.y[s] = points.y[order[s]];
    }
    return sorted;
}
//<

//> Fit, sort and copy
struct sorted sorted_make(const struct question *question, double c)
{
    const struct points points = question->points;
    struct sorted sorted = {.grid = grid_fit(question, c)};
    sorted.cells = cells_sort(&sorted.grid, points);
    sorted.points =
        points_in_order(points, sorted.cells.point, question->threads);
    note_built(question);
    return sorted;
}
//<

void sorted_free(struct sorted *sorted)
{
    points_free(&sorted->points);
    cells_free(&sorted->cells);
    grid_free(&sorted->grid);
}
//<

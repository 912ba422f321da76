// Cell sort in the plane, with the points: count, scan, and place each
// point with all it has.
#include "exercise.h"
#include <string.h>

void sort_into_cells(struct points points, struct grid grid,
                     struct sorted *sorted)
{
    //- solution
    uint32_t cells = grid.columns * grid.rows, *start = sorted->start;
    memset(start, 0, ((size_t)cells + 1) * sizeof *start);
    for (uint32_t i = 0; i < points.n; i++)
        start[cell_at(grid, points.x[i], points.y[i])]++;
    uint32_t sum = 0;
    for (uint32_t k = 0; k <= cells; k++) { // the ends of the cells
        sum += start[k];
        start[k] = sum;
    }
    for (uint32_t i = points.n; i-- > 0;) {
        uint32_t k = cell_at(grid, points.x[i], points.y[i]);
        uint32_t place = --start[k];
        sorted->x[place] = points.x[i];
        sorted->y[place] = points.y[i];
        sorted->index[place] = i;
    }
    //- starter
    // // Your turn. So far: all points in the last cell, as they came.
    // for (uint32_t k = 0; k < grid.columns * grid.rows; k++)
    //     sorted->start[k] = 0;
    // sorted->start[grid.columns * grid.rows] = points.n;
    // for (uint32_t i = 0; i < points.n; i++) {
    //     sorted->x[i] = points.x[i];
    //     sorted->y[i] = points.y[i];
    //     sorted->index[i] = i;
    // }
    //- end
}

//> Find the cell of every point
// See home.h.
#include "ch05-collisions/home.h"

void find_homes(const struct grid *grid, struct points points,
                uint32_t begin, uint32_t end, uint32_t *home)
{
    const struct grid g = *grid; // a copy: home cannot change it
    for (uint32_t i = begin; i < end; i++)
        home[i] = grid_cell(&g, points.x[i], points.y[i]);
}
//<

// Looks at every cell of the grid.
// expect: 2 of 10
#include "exercise.h"
#include <math.h>

struct found grow(const struct grid *grid, uint32_t column,
                  uint32_t row, double x, double y)
{
    (void)column, (void)row, (void)x, (void)y;
    struct found best = {NO_INDEX, INFINITY};
    for (uint32_t r = 0; r < grid->rows; r++)
        for (uint32_t c = 0; c < grid->columns; c++) {
            struct found here = look(c, r);
            if (here.nearest2 < best.nearest2 ||
                (here.nearest2 == best.nearest2 &&
                 here.nearest < best.nearest))
                best = here;
        }
    return best;
}

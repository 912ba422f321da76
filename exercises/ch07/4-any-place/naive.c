// Looks at all cells.
// expect: 3 of 10
#include "exercise.h"
#include <math.h>

struct found nearest_point(const struct grid *grid, double x, double y)
{
    struct found best = {NO_INDEX, INFINITY};
    (void)x, (void)y;
    for (uint32_t row = 0; row < grid->rows; row++)
        for (uint32_t column = 0; column < grid->columns; column++) {
            struct found here = look(column, row);
            if (here.nearest2 < best.nearest2 ||
                (here.nearest2 == best.nearest2 &&
                 here.nearest < best.nearest))
                best = here;
        }
    return best;
}

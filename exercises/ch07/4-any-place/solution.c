// A spiral search from the cell nearest to the query. Cells have
// gaps to the query, whether it stands in the grid or not.
#include "exercise.h"
#include <math.h>

//- solution
// The column of x, or the one nearest to it.
static int64_t nearest_to(const double *border, uint32_t count,
                          double x)
{
    int64_t k = 0;
    while (k + 1 < count && x >= border[k + 1])
        k++;
    return k;
}

// How far column k is from x.
static double gap(const double *border, int64_t k, double x)
{
    return fmax(0, fmax(border[k] - x, x - border[k + 1]));
}

static struct found better(struct found a, struct found b)
{
    if (a.nearest2 != b.nearest2)
        return a.nearest2 < b.nearest2 ? a : b;
    return a.nearest < b.nearest ? a : b;
}

// Whether the cell meets the square, of side twice the square root.
static int meets(const struct grid *grid, int64_t column, int64_t row,
                 double x, double y, double square2)
{
    double dx = gap(grid->column_border, column, x);
    double dy = gap(grid->row_border, row, y);
    return dx * dx <= square2 && dy * dy <= square2;
}

//- starter
//- end
struct found nearest_point(const struct grid *grid, double x, double y)
{
    //- solution
    int64_t column = nearest_to(grid->column_border, grid->columns, x);
    int64_t row = nearest_to(grid->row_border, grid->rows, y);
    int64_t last = grid->columns + grid->rows;
    struct found best = {NO_INDEX, INFINITY};
    double square2 = INFINITY; // until phase one is over
    for (int64_t k = 0; k < last; k++) {
        for (int64_t r = row - k; r <= row + k; r++) {
            int64_t step = r == row - k || r == row + k ? 1 : 2 * k;
            for (int64_t c = column - k; c <= column + k; c += step)
                if (c >= 0 && c < grid->columns && r >= 0 &&
                    r < grid->rows && meets(grid, c, r, x, y, square2))
                    best = better(best, look(c, r));
        }
        if (square2 == INFINITY && best.nearest != NO_INDEX)
            square2 = best.nearest2;
    }
    return best;
    //- starter
    // // Your turn: this looks in the first column only.
    // struct found best = {NO_INDEX, INFINITY};
    // for (uint32_t row = 0; row < grid->rows; row++) {
    //     struct found here = look(0, row);
    //     if (here.nearest2 + 0 * (x + y) < best.nearest2)
    //         best = here;
    // }
    // return best;
    //- end
}

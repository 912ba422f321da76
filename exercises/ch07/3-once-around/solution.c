// A layer as a ring in a window: no further back or on than half way
// round, or than the edge.
#include "exercise.h"

//- solution
// How far one may go from a cell, back and on.
struct view {
    int64_t back, on;
};

static struct view view_from(uint32_t cell, uint32_t count, bool wraps)
{
    if (wraps)
        return (struct view){(count - 1) / 2, count / 2};
    return (struct view){cell, count - 1 - cell};
}

static uint32_t go(uint32_t cell, int64_t steps, uint32_t count)
{
    return (uint32_t)((cell + steps + count) % count);
}

static int64_t fewer(int64_t a, int64_t b)
{
    return a < b ? a : b;
}

//- starter
//- end
uint32_t layer(const struct grid *grid, struct cell home, uint32_t k,
               struct cell *cells)
{
    //- solution
    struct view x = view_from(home.column, grid->columns, grid->wraps);
    struct view y = view_from(home.row, grid->rows, grid->wraps);
    int64_t far = k;
    uint32_t n = 0;
    for (int64_t dy = -fewer(far, y.back); dy <= fewer(far, y.on);
         dy++) {
        bool whole = dy == -far || dy == far;
        for (int64_t dx = -far; dx <= far; dx += whole ? 1 : 2 * far) {
            if (dx < -x.back)
                dx = whole ? -x.back : far;
            if (dx > x.on)
                break;
            cells[n++] =
                (struct cell){go(home.column, dx, grid->columns),
                              go(home.row, dy, grid->rows)};
        }
    }
    return n;
    //- starter
    // // Your turn: this is right for layer 0.
    // (void)grid;
    // cells[0] = home;
    // return k == 0;
    //- end
}

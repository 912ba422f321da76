// A layer as a ring in a search range: no further back or ahead than
// half way round, or than the edge.
#include "exercise.h"

//- solution
// Steps that one may take from a cell.
struct search_range {
    int64_t back, ahead;
};

static struct search_range range_from(uint32_t cell, uint32_t count,
                                      bool wraps)
{
    if (wraps)
        return (struct search_range){(count - 1) / 2, count / 2};
    return (struct search_range){cell, count - 1 - cell};
}

static uint32_t go(uint32_t cell, int64_t steps, uint32_t count)
{
    return (uint32_t)((cell + steps + count) % count);
}

static int64_t min(int64_t a, int64_t b)
{
    return a < b ? a : b;
}

//- starter
//- end
uint32_t layer(const struct grid *grid, struct cell home, uint32_t k,
               struct cell *cells)
{
    //- solution
    struct search_range x =
        range_from(home.column, grid->columns, grid->wraps);
    struct search_range y =
        range_from(home.row, grid->rows, grid->wraps);
    int64_t far = k;
    uint32_t n = 0;
    for (int64_t dy = -min(far, y.back); dy <= min(far, y.ahead);
         dy++) {
        bool whole = dy == -far || dy == far;
        for (int64_t dx = -far; dx <= far; dx += whole ? 1 : 2 * far) {
            if (dx < -x.back)
                dx = whole ? -x.back : far;
            if (dx > x.ahead)
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

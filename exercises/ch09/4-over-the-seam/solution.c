// Rows and the stretches of each are taken in ascending order, and a
// span that begins where the last one ends only makes it longer.
#include "exercise.h"

//- solution
// Appends the places from begin to end, and returns how many spans
// there are then.
static uint32_t append(struct span *spans, uint32_t n, uint32_t begin,
                       uint32_t end)
{
    if (begin == end)
        return n;
    if (n > 0 && spans[n - 1].end == begin) {
        spans[n - 1].end = end;
        return n;
    }
    spans[n] = (struct span){begin, end};
    return n + 1;
}

//- starter
//- end
uint32_t block_spans(const struct grid *grid, uint32_t column,
                     uint32_t row, uint32_t reach, struct span *spans)
{
    //- solution
    struct stretch x[2], y[2];
    uint32_t nx = stretches(column, reach, grid->columns, x);
    uint32_t ny = stretches(row, reach, grid->rows, y);
    uint32_t n = 0;
    for (uint32_t b = 0; b < ny; b++)
        for (uint32_t r = y[b].first; r <= y[b].last; r++)
            for (uint32_t a = 0; a < nx; a++) {
                const uint32_t *start = grid->start + r * grid->columns;
                n = append(spans, n, start[x[a].first],
                           start[x[a].last + 1]);
            }
    return n;
    //- starter
    // // Your turn: so far it is the cell of home only.
    // const uint32_t *start =
    //     grid->start + row * grid->columns + column;
    // spans[0] = (struct span){start[0], start[1]};
    // (void)reach;
    // return 1;
    //- end
}

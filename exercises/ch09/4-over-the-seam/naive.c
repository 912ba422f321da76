// A span for each stretch of each row, empty or not, none joined.
// expect: 3 of 10
#include "exercise.h"

uint32_t block_spans(const struct grid *grid, uint32_t column,
                     uint32_t row, uint32_t reach, struct span *spans)
{
    struct stretch x[2], y[2];
    uint32_t nx = stretches(column, reach, grid->columns, x);
    uint32_t ny = stretches(row, reach, grid->rows, y);
    uint32_t n = 0;
    for (uint32_t b = 0; b < ny; b++)
        for (uint32_t r = y[b].first; r <= y[b].last; r++)
            for (uint32_t a = 0; a < nx; a++) {
                const uint32_t *start = grid->start + r * grid->columns;
                spans[n++] = (struct span){start[x[a].first],
                                           start[x[a].last + 1]};
            }
    return n;
}

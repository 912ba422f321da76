// Goes through all cells and picks out those of the layer.
// expect: 4 of 10
#include "exercise.h"

static uint32_t away(uint32_t a, uint32_t b, uint32_t count, bool wraps)
{
    uint32_t direct = a > b ? a - b : b - a;
    return wraps && count - direct < direct ? count - direct : direct;
}

uint32_t layer(const struct grid *grid, struct cell home, uint32_t k,
               struct cell *cells)
{
    uint32_t n = 0;
    for (uint32_t r = 0; r < grid->rows; r++)
        for (uint32_t c = 0; c < grid->columns; c++) {
            uint32_t dx =
                away(home.column, c, grid->columns, grid->wraps);
            uint32_t dy = away(home.row, r, grid->rows, grid->wraps);
            if ((dx > dy ? dx : dy) == k)
                cells[n++] = (struct cell){c, r};
        }
    return n;
}

// Two spans for each row that crosses the seam, not joined.
// expect: 3 of 10
#include "exercise.h"

uint32_t block_spans(const struct grid *grid, uint32_t column,
                     uint32_t row, uint32_t reach, struct span *spans)
{
    uint32_t columns = grid->columns, rows = grid->rows, n = 0;
    for (uint32_t r = 0; r < rows; r++) {
        uint32_t up = (r + rows - row) % rows;
        if ((up < rows - up ? up : rows - up) > reach)
            continue;
        const uint32_t *start = grid->start + r * columns;
        for (uint32_t c = 0; c < columns; c++) {
            uint32_t on = (c + columns - column) % columns;
            if ((on < columns - on ? on : columns - on) > reach)
                continue;
            uint32_t first = c;
            while (c + 1 < columns) {
                on = (c + 1 + columns - column) % columns;
                if ((on < columns - on ? on : columns - on) > reach)
                    break;
                c++;
            }
            spans[n++] = (struct span){start[first], start[c + 1]};
        }
    }
    return n;
}

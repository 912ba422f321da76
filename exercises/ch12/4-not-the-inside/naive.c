// Looks at all points of the block.
// expect: 4 of 10
#include "exercise.h"

uint32_t count_in_box(const uint32_t *start, uint32_t columns,
                      struct cell_block block)
{
    uint32_t count = 0;
    for (uint32_t j = block.first_row; j <= block.last_row; j++)
        for (uint32_t s = start[j * columns + block.first_column];
             s < start[j * columns + block.last_column + 1]; s++)
            count += is_in_box(s);
    return count;
}

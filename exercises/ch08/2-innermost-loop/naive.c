// One task after the other, each to the end of its cell.
// expect: 4 of 10
#include "exercise.h"

void look_into_cells(struct strip *strip, const uint32_t *start)
{
    for (uint32_t l = 0; l < strip->lanes; l++) {
        uint32_t cell = strip->cell[l];
        for (uint32_t p = start[cell]; p < start[cell + 1]; p++)
            measure(1, &strip->task[l], &p);
    }
}

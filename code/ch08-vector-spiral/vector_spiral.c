//> Sort, then march
// See vector_spiral.h.
#include "ch08-vector-spiral/vector_spiral.h"
#include "ch08-vector-spiral/fused.h"
#include "ch08-vector-spiral/march.h"
#include "common/clock.h"
#include <stddef.h>

void sort_and_march(const struct question *question, struct loops loops,
                    struct answers *answers)
{
    struct grid grid = grid_fit(question, 1); // as the spiral
    struct cells cells = cells_sort(&grid, question->points);
    answers->built_ns = clock_ns();
    march(question, &grid, &cells, &loops, STRIP, answers, NULL, NULL);
    cells_free(&cells);
    grid_free(&grid);
}

void vector_spiral(const struct question *question,
                   struct answers *answers)
{
    sort_and_march(question, loops_fused(isa_chosen()), answers);
}
//<

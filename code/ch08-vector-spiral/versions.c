//> Sort, then search in one of many ways
// See versions.h.
#include "ch08-vector-spiral/versions.h"
#include "ch07-spiral/spiral.h"
#include "ch08-vector-spiral/by_primitives.h"
#include "ch08-vector-spiral/fused.h"
#include "ch08-vector-spiral/vector_spiral.h"
#include "common/clock.h"

void march_primitives(const struct question *question,
                      struct answers *answers)
{
    sort_and_march(question, loops_by_primitives(isa_chosen()),
                   answers);
}

void march_primitives_plain(const struct question *question,
                            struct answers *answers)
{
    sort_and_march(question, loops_by_primitives(PORTABLE), answers);
}

void march_fused_plain(const struct question *question,
                       struct answers *answers)
{
    sort_and_march(question, loops_fused(PORTABLE), answers);
}

void spiral_in_order(const struct question *question,
                     struct answers *answers)
{
    struct grid grid = grid_fit(question, 1);
    struct cells cells = cells_sort(&grid, question->points);
    answers->built_ns = clock_ns();
    search_spiral(question, &grid, &cells, cells.point, answers);
    cells_free(&cells);
    grid_free(&grid);
}
//<

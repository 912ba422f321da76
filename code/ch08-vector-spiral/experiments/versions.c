// One function for each version to be timed. Those in step differ in
// their kernels; the one point by point has its queries in another
// order than the table's.
#include "ch08-vector-spiral/experiments/versions.h"
#include "ch07-spiral/spiral.h"
#include "ch08-vector-spiral/by_primitives.h"
#include "ch08-vector-spiral/spiral_kernels.h"
#include "ch08-vector-spiral/vector_spiral.h"

void spiral_primitives(const struct question *question,
                       struct answers *answers)
{
    sort_and_search(question, &spiral_by_primitives[isa_chosen()],
                    answers);
}

void spiral_primitives_plain(const struct question *question,
                             struct answers *answers)
{
    sort_and_search(question, &spiral_by_primitives[PORTABLE], answers);
}

void spiral_fused_plain(const struct question *question,
                        struct answers *answers)
{
    sort_and_search(question, spiral_kernels(PORTABLE), answers);
}

void spiral_in_order(const struct question *question,
                     struct answers *answers)
{
    struct grid grid = grid_fit(question, 1);
    struct cells cells = cells_sort(&grid, question->points);
    note_built(question);
    search_spiral(question, &grid, &cells, cells.point, answers);
    cells_free(&cells);
    grid_free(&grid);
}

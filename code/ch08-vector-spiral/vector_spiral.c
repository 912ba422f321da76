//> Sort, then search in lockstep
// Chapter 4's sort into cells, one point to a cell on average, then all
// searches in strips of 1,024 tasks.
#include "ch08-vector-spiral/vector_spiral.h"
#include "ch08-vector-spiral/lockstep.h"

void sort_and_search(const struct question *question,
                     const struct spiral_kernels *kernels,
                     struct answers *answers)
{
    struct grid grid = grid_fit(question, 1); // as the spiral
    struct cells cells = cells_sort(&grid, question->points);
    note_built(question);
    struct strip_plan plan = {.kernels = kernels, .length = STRIP};
    search_in_lockstep(question, &grid, &cells, &plan, answers);
    cells_free(&cells);
    grid_free(&grid);
}

void vector_spiral(const struct question *question,
                   struct answers *answers)
{
    sort_and_search(question, spiral_kernels(isa_chosen()), answers);
}
//<

//> Search the cells with threads
// Two stages in one workspace; the second is chapter 4's. About 25
// bytes a point while the points are sorted, and 23 that stay.
#include "ch05-collisions/cells_threads.h"
#include "ch04-cell-sort/batches.h"
#include "ch05-collisions/partition.h"
#include "common/clock.h"

void cells_threads(const struct question *question,
                   struct answers *answers)
{
    struct workspace own = {0};
    struct workspace *workspace =
        question->workspace ? question->workspace : &own;
    struct mark mark = workspace_mark(workspace);
    struct partition partition = partition_make(
        question, POINTS_PER_CELL, NO_RESTORE, workspace);
    answers->built_ns = clock_ns();
    search_batches(question, &partition.sorted, answers);
    workspace_release(workspace, mark);
    workspace_free(&own);
}
//<

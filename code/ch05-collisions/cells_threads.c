//> Search the cells with threads
// Two stages in one workspace; the second is chapter 4's. About 25
// bytes a point while the points are sorted, and 23 that stay.
#include "ch05-collisions/cells_threads.h"
#include "ch04-cell-sort/batches.h"
#include "ch05-collisions/partition.h"

static void partition_and_search(const struct question *question,
                                 struct answers *answers)
{
    struct partition partition = partition_make(
        question, POINTS_PER_CELL, NO_RESTORE, question->workspace);
    search_batches(question, &partition.sorted, answers);
}

void cells_threads(const struct question *question,
                   struct answers *answers)
{
    search_in_workspace(question, partition_and_search, answers);
}
//<

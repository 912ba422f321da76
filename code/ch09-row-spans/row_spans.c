//> Search by row spans
// The three stages, one after the other, in one workspace: records and
// results, of 24 and 16 bytes, use the same memory.
#include "ch09-row-spans/row_spans.h"
#include "ch09-row-spans/point_query.h"
#include "ch09-row-spans/span_kernels.h"
#include "common/clock.h"
#include <assert.h>

//> Answer exactly for the nearest
static void exact_nearest(const struct scene *scene,
                          const void *context, uint32_t s,
                          struct neighbor *found, struct counts *counts)
{
    (void)context;
    struct point_query query = nearest_query(scene, s);
    *found = (struct neighbor){query.best2, query.nearest};
    counts->distances += query.compared;
}

struct batch_search nearest_search(const struct scene *scene,
                                   const uint32_t *inverse,
                                   struct neighbor *results)
{
    return (struct batch_search){.kernel = scene->kernels->nearest,
                                 .max_reach = INFINITY,
                                 .exact = exact_nearest,
                                 .results = results,
                                 .inverse = inverse};
}
//<

//> Search batches, then restore order
void search_row_spans(const struct question *question,
                      const struct partition *partition,
                      struct workspace *workspace,
                      struct answers *answers)
{
    assert(partition->inverse && "order can be restored");
    const uint32_t n = question->points.n;
    const struct scene scene = {question->space, &partition->sorted,
                                span_kernels()};
    struct mark mark = workspace_mark(workspace);
    struct neighbor *results =
        workspace_take(workspace, n, sizeof *results);
    struct batch_search search =
        nearest_search(&scene, partition->inverse, results);
    answer_all(question, &scene, &search, 1);
    restore_order(results, partition->permutation, n, question->threads,
                  answers->nearest, answers->nearest2);
    workspace_release(workspace, mark);
}
//<

//> Partition, search, restore
void row_spans(const struct question *question, struct answers *answers)
{
    struct workspace own = {0};
    struct workspace *workspace =
        question->workspace ? question->workspace : &own;
    struct mark mark = workspace_mark(workspace);
    struct partition partition = partition_make(
        question, POINTS_PER_SPAN_CELL, RESTORE, workspace);
    answers->built_ns = clock_ns();
    search_row_spans(question, &partition, workspace, answers);
    workspace_release(workspace, mark);
    workspace_free(&own);
}
//<
//<

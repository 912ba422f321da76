//> Search by row spans
// The three stages, one after the other, in one workspace: records and
// results, of 24 and 16 bytes, use the same memory.
#include "ch09-row-spans/row_spans.h"
#include "ch09-row-spans/point_query.h"
#include "ch09-row-spans/span_kernels.h"
#include <stddef.h>

//> Answer exactly for the nearest
static void exact_nearest(const struct scene *scene,
                          const void *context, uint32_t s,
                          struct neighbor *found, struct counts *counts)
{
    (void)context;
    struct query query = nearest_query(scene, s);
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
    const struct scene scene = {question->space, &partition->sorted,
                                span_kernels()};
    struct batch_search search = nearest_search(&scene, NULL, NULL);
    search.index = answers->nearest;
    search.distance2 = answers->nearest2;
    answer_in_order(question, &scene, partition, workspace, &search, 1);
}
//<

//> Partition, search, restore
static void partition_and_search(const struct question *question,
                                 struct answers *answers)
{
    struct workspace *workspace = question->workspace;
    struct partition partition = partition_make(
        question, POINTS_PER_SPAN_CELL, RESTORE, workspace);
    search_row_spans(question, &partition, workspace, answers);
}

void row_spans(const struct question *question, struct answers *answers)
{
    search_in_workspace(question, partition_and_search, answers);
}
//<
//<

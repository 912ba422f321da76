//> Search the furthest by batches
// A second kernel for the batches that chapter 9 stages, and its exact
// query. Evenly spread, one query in a hundred needs that.
#include "ch10-furthest/furthest_batches.h"
#include "ch09-row-spans/span_kernels.h"
#include "ch10-furthest/furthest_cells.h"
#include "ch10-furthest/furthest_kernels.h"
#include "ch10-furthest/outside.h"
#include <assert.h>

//> Compare one query with some points
static void compare_points(const struct far_scene *scene,
                           uint32_t begin, uint32_t end,
                           struct far_batch *query)
{
    for (uint32_t s = begin; s < end; s++)
        compare_far(WRAPAROUND, 1, scene, s, query);
    query->counts->distances += end - begin;
}
//<

//> Compare with a wider block
// By a cell on each side. Says whether no point outside can be further.
static bool compare_block(const struct far_scene *scene,
                          struct far_batch *query)
{
    const struct grid *grid = &scene->sorted->grid;
    const uint32_t columns = grid->x.count;
    const double x = query->x[0], y = query->y[0];
    const struct block block = block_of(grid, x, y, 2);
    const uint32_t first = block.x.first, end = first + block.x.count;
    for (uint32_t k = 0; k < block.y.count; k++) {
        const uint32_t row = range_cell(&grid->y, &block.y, k);
        const uint32_t *start =
            scene->sorted->cells.start + row * columns;
        compare_points(scene, start[first],
                       start[end < columns ? end : columns], query);
        if (end > columns)
            compare_points(scene, start[0], start[end - columns],
                           query);
    }
    return query->max2[0] >
           furthest_outside2(grid, &block, scene->space, x, y);
}
//<

//> Answer exactly for the furthest
// What the kernel has found is a point, if not the furthest, and need
// not be found again. The context is a list of rows.
static void exact_furthest(const struct scene *scene,
                           const void *context, uint32_t s,
                           struct neighbor *found,
                           struct counts *counts)
{
    const struct far_scene far = {scene->sorted, context, scene->space};
    struct far_batch query;
    begin_far_batch(1, scene->sorted, s, &query);
    query.counts = counts;
    if (found->index != NO_INDEX && found->index != query.self[0]) {
        query.max2[0] = found->distance2;
        query.furthest[0] = found->index;
    }
    if (!compare_block(&far, &query))
        search_from_outside(WRAPAROUND, 1, &far, &query);
    found->distance2 = query.max2[0];
    found->index = (uint32_t)query.furthest[0];
}
//<

//> Search batches for both
void search_near_and_far_batches(const struct question *question,
                                 const struct partition *partition,
                                 struct workspace *workspace,
                                 struct answers *answers)
{
    assert(question->space.geometry == WRAPAROUND &&
           "in the plane the furthest is far from the batch");
    const uint32_t n = question->points.n;
    const struct scene scene = {question->space, &partition->sorted,
                                span_kernels()};
    struct mark mark = workspace_mark(workspace);
    const struct rows rows = rows_find(&partition->sorted, workspace);
    struct neighbor *near = NULL, *far = NULL;
    struct batch_search searches[2];
    int count = 0;
    //> Search for either half that is wanted
    if (answers->nearest) {
        near = workspace_take(workspace, n, sizeof *near);
        searches[count++] =
            nearest_search(&scene, partition->inverse, near);
    }
    if (answers->furthest) {
        far = workspace_take(workspace, n, sizeof *far);
        searches[count++] = (struct batch_search){
            .kernel = furthest_kernel(),
            .max_reach = furthest_max_reach(question->space),
            .exact = exact_furthest,
            .context = &rows,
            .results = far,
            .inverse = partition->inverse};
    }
    //<
    answer_all(question, &scene, searches, count);
    if (near)
        restore_order(near, partition->permutation, n,
                      question->threads, answers->nearest,
                      answers->nearest2);
    if (far)
        restore_order(far, partition->permutation, n, question->threads,
                      answers->furthest, answers->furthest2);
    workspace_release(workspace, mark);
}
//<
//<

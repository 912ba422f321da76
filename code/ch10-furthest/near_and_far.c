//> Search near and far
// One partition for both halves. With wraparound one batch search finds
// both, with two kernels; what the furthest kernel cannot certify is
// compared with a wider block, and then searched for from outside. In
// the plane the furthest are looked up in the candidate grid of the
// hull.
#include "ch10-furthest/near_and_far.h"
#include "ch09-row-spans/row_spans.h"
#include "ch09-row-spans/span_kernels.h"
#include "ch10-furthest/candidate_search.h"
#include "ch10-furthest/furthest_branch_and_bound.h"
#include "ch10-furthest/furthest_cells.h"
#include "ch10-furthest/furthest_kernels.h"
#include "ch10-furthest/hull_candidates.h"

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
static void search_both_in_batches(const struct question *question,
                                   const struct partition *partition,
                                   struct workspace *workspace,
                                   struct answers *answers)
{
    const struct scene scene = {question->space, &partition->sorted,
                                span_kernels()};
    struct mark mark = workspace_mark(workspace);
    const struct rows rows = rows_find(&partition->sorted, workspace);
    struct batch_search searches[2];
    int count = 0;
    //> Search for either half that is wanted
    if (answers->nearest) {
        searches[count] = nearest_search(&scene, NULL, NULL);
        searches[count].index = answers->nearest;
        searches[count++].distance2 = answers->nearest2;
    }
    if (answers->furthest)
        searches[count++] = (struct batch_search){
            .kernel = furthest_kernel(),
            .max_reach = furthest_max_reach(question->space),
            .exact = exact_furthest,
            .context = &rows,
            .index = answers->furthest,
            .distance2 = answers->furthest2};
    //<
    answer_in_order(question, &scene, partition, workspace, searches,
                    count);
    workspace_release(workspace, mark);
}
//<

//> Find the furthest among few corners
static void furthest_among(const struct question *question,
                           struct corners corners,
                           struct answers *answers)
{
    const struct candidate_grid grid = candidate_grid_make(
        &corners, question->points.n, question->workspace);
    search_candidate_grid(question, &corners, &grid, answers);
}
//<

//> Search what is in cells
void search_near_and_far(const struct question *question,
                         const struct partition *partition,
                         struct answers *answers)
{
    struct workspace *workspace = question->workspace;
    if (question->space.geometry == WRAPAROUND) {
        search_both_in_batches(question, partition, workspace, answers);
        return;
    }
    search_row_spans(question, partition, workspace, answers);
    if (answers->furthest)
        furthest_among(
            question,
            corners_of_sorted(question, &partition->sorted, workspace),
            answers);
}
//<

//> Partition once for both
// As for the nearest alone.
struct partition partition_for_both(const struct question *question,
                                    const struct answers *answers)
{
    const bool two = question->space.geometry == WRAPAROUND &&
                     answers->nearest && answers->furthest;
    return partition_make(question, PER_CELL_FOR_BOTH,
                          two ? RESTORE_TWO : RESTORE,
                          question->workspace);
}

static void partition_and_search(const struct question *question,
                                 struct answers *answers)
{
    const struct partition partition =
        partition_for_both(question, answers);
    search_near_and_far(question, &partition, answers);
}
//<

//> Answer near and far
static void find_furthest(const struct question *question,
                          struct answers *answers)
{
    furthest_among(
        question, corners_find(question, question->workspace), answers);
}

void near_and_far(const struct question *question,
                  struct answers *answers)
{
    const bool plane = question->space.geometry == STANDARD;
    search_in_workspace(question,
                        plane && !answers->nearest
                            ? find_furthest
                            : partition_and_search,
                        answers);
}
//<
//<

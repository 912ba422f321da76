//> Search the cells from outside
// Rows from the outside inward and in each its cells, for eight queries
// that stand together or for one, by the batch search's chunks; then
// order is restored. See furthest_branch_and_bound.h for the search
// itself.
#include "ch10-furthest/furthest_cells.h"
#include "ch10-furthest/furthest_branch_and_bound.h"
#include <assert.h>

//> Find the rows that have points
struct rows rows_find(const struct sorted *sorted,
                      struct workspace *workspace)
{
    const uint32_t columns = sorted->grid.x.count;
    const uint32_t n = sorted->grid.y.count;
    const uint32_t *start = sorted->cells.start;
    struct rows rows = {0, workspace_take(workspace, n, sizeof *start),
                        workspace_take(workspace, n, sizeof *start)};
    for (uint32_t row = 0; row < n; row++) {
        rows.place[row] = rows.count;
        rows.row[rows.count] = row;
        rows.count += start[row * columns] < start[(row + 1) * columns];
    }
    return rows;
}
//<

//> Say whether eight stand together
// In one row, so that with wraparound their own cells are one stretch,
// and a short one, for it is compared first.
static bool stand_together(const struct sorted *sorted, uint32_t s,
                           uint32_t end)
{
    if (end - s < FAR_BATCH)
        return false;
    const uint32_t last = s + FAR_BATCH - 1;
    const struct axis *across = &sorted->grid.x, *up = &sorted->grid.y;
    const double *x = sorted->points.x, *y = sorted->points.y;
    return axis_cell(up, y[s]) == axis_cell(up, y[last]) &&
           axis_cell(across, x[last]) <
               axis_cell(across, x[s]) + FAR_BATCH;
}
//<

//> Search for a batch or for one query
// For as many of the sorted points as there are lanes, from s on.
INLINED void search_lanes(const enum geometry geometry,
                          const uint32_t lanes,
                          const struct far_scene *scene, uint32_t s,
                          struct neighbor *found, struct counts *counts)
{
    struct far_batch batch;
    begin_far_batch(lanes, scene->sorted, s, &batch);
    batch.counts = counts;
    search_from_outside(geometry, lanes, scene, &batch);
    for (uint32_t lane = 0; lane < lanes; lane++) {
        found[lane].distance2 = batch.max2[lane];
        found[lane].index = (uint32_t)batch.furthest[lane];
    }
}
//<

//> Search from outside for one query
void furthest_of_one(const struct far_scene *scene, uint32_t s,
                     struct neighbor *found, struct counts *counts)
{
    IN_GEOMETRY(scene->space, search_lanes, 1, scene, s, found, counts);
}
//<

//> Search a chunk from outside
struct far_search {
    struct far_scene scene;
    const uint32_t *inverse;
    struct neighbor *results;
};

static void search_chunk(const void *context, uint32_t begin,
                         uint32_t end, struct counts *counts)
{
    const struct far_search *search = context;
    const struct far_scene *scene = &search->scene;
    struct neighbor found[FAR_BATCH];
    for (uint32_t s = begin, lanes; s < end; s += lanes) {
        lanes = stand_together(scene->sorted, s, end) ? FAR_BATCH : 1;
        if (lanes > 1)
            IN_GEOMETRY(scene->space, search_lanes, FAR_BATCH, scene, s,
                        found, counts);
        else
            furthest_of_one(scene, s, found, counts);
        for (uint32_t lane = 0; lane < lanes; lane++)
            search->results[search->inverse[s + lane]] = found[lane];
    }
}
//<

//> Search the cells of a partition
void search_furthest_cells(const struct question *question,
                           const struct partition *partition,
                           struct workspace *workspace,
                           struct answers *answers)
{
    assert(partition->inverse && "order can be restored");
    const uint32_t n = question->points.n;
    const struct sorted *sorted = &partition->sorted;
    struct mark mark = workspace_mark(workspace);
    struct neighbor *results =
        workspace_take(workspace, n, sizeof *results);
    const struct rows rows = rows_find(sorted, workspace);
    const struct far_search search = {
        {sorted, &rows, question->space}, partition->inverse, results};
    share_chunks(question, search_chunk, &search);
    restore_order(results, partition->permutation, n, question->threads,
                  answers->furthest, answers->furthest2);
    workspace_release(workspace, mark);
}
//<

static void partition_and_search(const struct question *question,
                                 struct answers *answers)
{
    struct workspace *workspace = question->workspace;
    struct partition partition = partition_make(
        question, POINTS_PER_FAR_CELL, RESTORE, workspace);
    search_furthest_cells(question, &partition, workspace, answers);
}

void furthest_cells(const struct question *question,
                    struct answers *answers)
{
    search_in_workspace(question, partition_and_search, answers);
}
//<

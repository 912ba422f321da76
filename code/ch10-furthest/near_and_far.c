//> Search near and far
// One partition for both halves. With wraparound one batch search finds
// both, too; in the plane the furthest are looked up in the candidate
// grid of the hull.
#include "ch10-furthest/near_and_far.h"
#include "ch10-furthest/candidate_search.h"
#include "ch10-furthest/furthest_batches.h"
#include "ch10-furthest/hull_candidates.h"
#include "common/clock.h"

//> Find the furthest among few corners
static void furthest_among(const struct question *question,
                           struct corners corners,
                           struct workspace *workspace,
                           struct answers *answers)
{
    struct mark mark = workspace_mark(workspace);
    const struct candidate_grid grid =
        candidate_grid_make(&corners, question->points.n, workspace);
    search_candidate_grid(question, &corners, &grid, answers);
    corners_free(&corners);
    workspace_release(workspace, mark);
}
//<

//> Partition once for both
// For the furthest, too, a fuller cell is a better one.
static const double per_cell = 2;

static void search_both(const struct question *question,
                        const struct partition *partition,
                        struct workspace *workspace,
                        struct answers *answers)
{
    if (question->space.geometry == WRAPAROUND) {
        search_near_and_far_batches(question, partition, workspace,
                                    answers);
        return;
    }
    search_row_spans(question, partition, workspace, answers);
    if (answers->furthest)
        furthest_among(
            question,
            corners_of_sorted(question, &partition->sorted, workspace),
            workspace, answers);
}
//<

//> Reserve room for both results
// Results for both take more room than the records.
static void reserve(struct workspace *workspace,
                    const struct question *question)
{
    const size_t kept = 16 + 3 * 4 + 2 + 1, result = 16;
    workspace_reserve(workspace,
                      question->points.n * (kept + 2 * result),
                      question->threads);
}
//<

//> Answer near and far
void near_and_far(const struct question *question,
                  struct answers *answers)
{
    struct workspace own = {0};
    struct workspace *workspace =
        question->workspace ? question->workspace : &own;
    struct mark mark = workspace_mark(workspace);
    if (!answers->nearest && question->space.geometry == STANDARD) {
        furthest_among(question, corners_find(question), workspace,
                       answers);
    } else {
        if (answers->nearest && question->space.geometry == WRAPAROUND)
            reserve(workspace, question);
        struct partition partition =
            partition_make(question, per_cell, RESTORE, workspace);
        answers->built_ns = clock_ns();
        search_both(question, &partition, workspace, answers);
    }
    workspace_release(workspace, mark);
    workspace_free(&own);
}
//<
//<

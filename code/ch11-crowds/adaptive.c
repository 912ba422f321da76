//> Search in a partition that adapts
// Three stages, as in chapter 9. Queries that have given up share what
// all queries together were allowed; if some give up again, they are
// left to divide and conquer. So the steps are n log n at worst.
#include "ch11-crowds/adaptive.h"
#include "ch11-crowds/divide.h"
#include "ch11-crowds/far_search.h"
#include "ch11-crowds/piece_batches.h"
#include "ch11-crowds/point_search.h"

//> Search once more
// The steps that n queries were allowed are now for count of them: if
// there are as few as steps, each may look at all points. Those that
// still give up move to the front of the list.
static uint32_t search_again(const struct question *question,
                             const struct pieces *pieces,
                             uint64_t max_steps, uint32_t *query,
                             uint32_t count, struct answers *answers)
{
    const uint64_t each = max_steps * question->points.n / count;
    const struct scene all = scene_of(question, pieces);
    uint32_t left = 0;
#pragma omp parallel for num_threads(question->threads) \
    schedule(dynamic)
    for (uint32_t k = 0; k < count; k++) {
        struct counts counts = {0};
        const uint32_t s = query[k], i = pieces->sorted.cells.point[s];
        const struct neighbor found =
            nearest_of_all(&all, pieces, s, each, &counts);
        answers->nearest[i] = found.index;
        answers->nearest2[i] = found.distance2;
        counts_add(question->counts, &counts);
    }
    for (uint32_t k = 0; k < count; k++) {
        const uint32_t i = pieces->sorted.cells.point[query[k]];
        if (answers->nearest[i] == NO_INDEX)
            query[left++] = i;
    }
    return left;
}
//<

//> Find those that have given up
static uint32_t list_given_up(const struct pieces *pieces,
                              const struct answers *answers,
                              uint32_t *query)
{
    uint32_t count = 0;
    for (uint32_t s = 0; s < pieces->sorted.points.n; s++)
        if (answers->nearest[pieces->sorted.cells.point[s]] == NO_INDEX)
            query[count++] = s;
    return count;
}
//<

void search_nearest_pieces(const struct question *question,
                           const struct pieces *pieces,
                           uint64_t max_steps,
                           struct workspace *workspace,
                           struct answers *answers)
{
    const uint32_t n = question->points.n;
    struct mark mark = workspace_mark(workspace);
    struct neighbor *results =
        workspace_take(workspace, n, sizeof *results);
    uint32_t given_up =
        search_pieces(question, pieces, max_steps, results);
    restore_order(results, pieces->permutation, n, question->threads,
                  answers->nearest, answers->nearest2);
    workspace_release(workspace, mark);
    if (given_up > 0) {
        uint32_t *query =
            workspace_take(workspace, given_up, sizeof *query);
        given_up = list_given_up(pieces, answers, query);
        given_up = search_again(question, pieces, max_steps, query,
                                given_up, answers);
        if (given_up > 0)
            search_divide_and_conquer(question, query, given_up,
                                      workspace, answers);
    }
    workspace_release(workspace, mark);
}

static void cut_and_search(const struct question *question,
                           struct answers *answers)
{
    struct workspace *workspace = question->workspace;
    const struct pieces pieces = pieces_make(question, workspace);
    note_built(question);
    if (answers->nearest)
        search_nearest_pieces(question, &pieces,
                              steps_allowed(question->points.n),
                              workspace, answers);
    if (answers->furthest)
        search_furthest_pieces(question, &pieces, workspace, answers);
}

void adaptive(const struct question *question, struct answers *answers)
{
    search_in_workspace(question, cut_and_search, answers);
}
//<

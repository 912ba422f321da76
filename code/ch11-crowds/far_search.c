//> Search for the furthest by pieces
// Queries come in the order of the pieces: the furthest of one is
// nearly that of the next.
#include "ch11-crowds/far_search.h"
#include "ch09-row-spans/batch_search.h"
#include "ch10-furthest/candidate_search.h"
#include "ch11-crowds/arcs.h"
#include "ch11-crowds/point_search.h"
#include "common/min_max.h"

//> Hold a search for the furthest
struct far_search {
    const struct question *question;
    const struct pieces *pieces;
    const struct arcs *arcs; // NULL: all pieces are searched
    struct neighbor *results;
};
//<

//> Search a leaf by arcs
// In strips of queries that are near each other: a shortlist for the
// box of a strip, and for each query of it.
enum { STRIP = 32 };

static void search_strip(const struct far_search *search,
                         struct points points, const uint32_t *inverse,
                         struct arc_query *query)
{
    struct shortlist list;
    const struct box box = box_around(points);
    arcs_list(search->arcs, &box, query, &list);
    for (uint32_t s = 0; s < points.n; s++) {
        query->x = points.x[s];
        query->y = points.y[s];
        if (list.complete)
            arcs_furthest_listed(search->arcs, &list, query);
        else
            arcs_furthest(search->arcs, query);
        search->results[inverse[s]] =
            (struct neighbor){query->max2, query->furthest};
    }
}

static void search_by_arcs(const struct far_search *search,
                           uint32_t begin, uint32_t end,
                           struct counts *counts)
{
    const struct pieces *pieces = search->pieces;
    const struct points all = pieces->sorted.points;
    struct arc_query query = {0};
    for (uint32_t s = begin; s < end; s += STRIP)
        search_strip(
            search,
            (struct points){MIN(STRIP, end - s), all.x + s, all.y + s},
            pieces->inverse + s, &query);
    counts->distances += query.compared;
}
//<

//> Search a leaf by boxes
static void search_by_boxes(const struct far_search *search,
                            uint32_t begin, uint32_t end,
                            struct counts *counts)
{
    const struct pieces *pieces = search->pieces;
    const struct scene all = scene_of(search->question, pieces);
    for (uint32_t s = begin; s < end; s++)
        search->results[pieces->inverse[s]] =
            furthest_of_all(&all, pieces, s, counts);
}
//<

//> Search all leaves
static void search_leaves(const struct far_search *search)
{
    const struct pieces *pieces = search->pieces;
    const struct question *question = search->question;
#pragma omp parallel for num_threads(question->threads) \
    schedule(dynamic)
    for (uint32_t k = 0; k < pieces->leaves; k++) {
        struct counts counts = {0};
        for (uint32_t i = 0; i < pieces->count[k]; i++) {
            const struct piece *piece =
                &pieces->piece[pieces->first[k] + i];
            const uint32_t begin = piece->begin;
            const uint32_t end = begin + piece->sorted.points.n;
            if (search->arcs)
                search_by_arcs(search, begin, end, &counts);
            else
                search_by_boxes(search, begin, end, &counts);
        }
        counts_add(question->counts, &counts);
    }
}

static void search_and_restore(struct far_search search,
                               struct workspace *workspace,
                               struct answers *answers)
{
    const uint32_t n = search.question->points.n;
    search.results =
        workspace_take(workspace, n, sizeof *search.results);
    search_leaves(&search);
    restore_order(search.results, search.pieces->permutation, n,
                  search.question->threads, answers->furthest,
                  answers->furthest2);
}
//<

//> Measure the lists of corners
// How many corners a point is compared with in the candidate grid, on
// average over a sample.
enum { SAMPLE = 1024 };

static double length_of_lists(const struct question *question,
                              struct points all,
                              const struct corners *corners,
                              const struct candidate_grid *grid)
{
    const uint32_t n = MIN(all.n, SAMPLE);
    struct workspace *workspace = question->workspace;
    struct mark mark = workspace_mark(workspace);
    const struct points sample = corners_take(n, workspace).points;
    struct answers answers = {
        .furthest = workspace_take(workspace, n, sizeof(uint32_t)),
        .furthest2 = workspace_take(workspace, n, sizeof(double))};
    struct counts counts = {0};
    for (uint32_t k = 0; k < n; k++) {
        const uint32_t s = (uint64_t)all.n * k / n;
        sample.x[k] = all.x[s];
        sample.y[k] = all.y[s];
    }
    const struct question some = {sample, question->space, 1, &counts};
    search_candidate_grid(&some, corners, grid, &answers);
    workspace_release(workspace, mark);
    return (double)counts.distances / n;
}
//<

//> Search for the furthest corner
bool search_few_corners(const struct question *question,
                        struct points all, struct corners corners,
                        struct answers *answers)
{
    enum { MANY_CORNERS = 1024 };
    const double short_list = PER_ARC;
    if (corners.points.n > MANY_CORNERS)
        return false;
    corners = corners_by_index(corners, question->workspace);
    const struct candidate_grid grid = candidate_grid_make(
        &corners, question->points.n, question->workspace);
    if (length_of_lists(question, all, &corners, &grid) > short_list)
        return false;
    search_candidate_grid(question, &corners, &grid, answers);
    return true;
}

static void search_corners_of(const struct far_search *search,
                              struct workspace *workspace,
                              struct answers *answers)
{
    const struct sorted *sorted = &search->pieces->sorted;
    const struct corners corners = corners_from_left(
        (struct corners){sorted->points, sorted->cells.point},
        search->question->threads, workspace);
    if (!search_few_corners(search->question, sorted->points, corners,
                            answers)) {
        const struct arcs arcs = arcs_make(&corners, workspace);
        struct far_search by_arcs = *search;
        by_arcs.arcs = &arcs;
        search_and_restore(by_arcs, workspace, answers);
    }
}
//<

void search_furthest_pieces(const struct question *question,
                            const struct pieces *pieces,
                            struct workspace *workspace,
                            struct answers *answers)
{
    const struct box *box = &pieces->node[0].box;
    const double diagonal2 =
        distance2(box->right - box->left, box->top - box->bottom);
    const struct far_search search = {question, pieces, NULL, NULL};
    struct mark mark = workspace_mark(workspace);
    if (question->space.geometry == STANDARD && diagonal2 > MIN_D2 &&
        diagonal2 < MAX_D2)
        search_corners_of(&search, workspace, answers);
    else
        search_and_restore(search, workspace, answers);
    workspace_release(workspace, mark);
}
//<

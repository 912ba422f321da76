//> Find neighbors in the plane
// A thread takes stretches of sorted points: what one query has brought
// into the caches is what the next one needs. To fill lists costs, for
// each point, the query and one place in memory that is seldom cached.
#include "ch12-range-queries/plane_neighbors.h"
#include "ch12-range-queries/plane_query.h"
#include "common/min_max.h"
#include <assert.h>
#include <math.h>

//> Hold what all queries of the plane want
struct wanted {
    const struct plane_index *index;
    double reach2;
    const struct neighbor_lists *lists; // to be filled, or NULL: then
    uint32_t *count;                    // they are counted
    uint32_t max_k;                     // in a list
};
//<

//> Hand over a list
static void hand_over(const struct k_nearest_list *list,
                      const struct neighbor_lists *lists)
{
    const uint64_t start = list_start(lists, list->self);
    assert(start + list->count == list_start(lists, list->self + 1) &&
           "the list is full");
    for (size_t k = 0; k < list->count; k++) {
        lists->index[start + k] = list->found[k].index;
        lists->distance2[start + k] = list->found[k].distance2;
    }
}
//<

//> Ask for one point of the plane
static void ask_for_point(const struct wanted *wanted, uint32_t s,
                          struct plane_query *query)
{
    const struct sorted *sorted = &wanted->index->pieces.sorted;
    const struct neighbor_lists *lists = wanted->lists;
    const uint32_t i = sorted->cells.point[s];
    if (lists && (i < lists->first || i >= lists->last))
        return;
    //> Fetch the place of a list
    // It is seldom in a cache. Asked for before the query runs, it is
    // there when the list is full.
    if (lists) {
        const uint64_t start = list_start(lists, i);
        __builtin_prefetch(lists->index + start, 1);
        __builtin_prefetch(lists->distance2 + start, 1);
        __builtin_prefetch(lists->distance2 + start + 7, 1);
    }
    //<
    query->x = sorted->points.x[s];
    query->y = sorted->points.y[s];
    query->has_block = false;
    k_nearest_list_clear(query->list, i, wanted->reach2);
    plane_query_run(query);
    if (!lists) {
        wanted->count[i] = (uint32_t)query->list->count;
        return;
    }
    keep_k_nearest(query->list);
    hand_over(query->list, lists);
}
//<

//> Ask for a stretch of the plane
// Of sorted points; from piece to piece.
static void ask_for_stretch(const struct wanted *wanted, uint32_t s,
                            uint32_t end, struct plane_query *query)
{
    const struct plane_index *index = wanted->index;
    for (uint32_t k = piece_of(index, s); s < end; k++) {
        const struct piece *piece =
            &index->pieces.piece[index->piece[k]];
        const uint32_t stop =
            MIN(end, piece->begin + piece->sorted.points.n);
        query->piece = piece;
        for (; s < stop; s++)
            ask_for_point(wanted, s, query);
    }
}
//<

//> Ask for all points of the plane
// Each thread has a list of its own, and takes a stretch at a time.
enum { STRETCH = 256 };

static void ask_for_all(const struct wanted *wanted,
                        struct counts *counts)
{
    const struct plane_index *index = wanted->index;
    const uint32_t n = index->pieces.sorted.points.n;
    const uint32_t stretches = (n - 1) / STRETCH + 1;
#pragma omp parallel num_threads(index->threads)
    {
        struct k_nearest_list list = {0};
        if (wanted->lists)
            list = k_nearest_list_make(wanted->max_k);
        struct plane_query query = {.index = index, .list = &list};
#pragma omp for schedule(dynamic)
        for (uint32_t k = 0; k < stretches; k++) {
            const uint32_t s = k * STRETCH;
            ask_for_stretch(wanted, s, s + MIN(n - s, STRETCH), &query);
        }
        const struct counts mine = {.distances = query.compared,
                                    .cells = query.steps};
        counts_add(counts, &mine);
        k_nearest_list_free(&list);
    }
}
//<

//> Count or fill
void count_plane_within(const struct plane_index *index, double reach2,
                        uint32_t *count, struct counts *counts)
{
    const struct wanted wanted = {index, reach2, NULL, count, 0};
    ask_for_all(&wanted, counts);
}

void fill_plane_lists(const struct plane_index *index, double reach2,
                      const struct neighbor_lists *lists,
                      struct counts *counts)
{
    struct wanted wanted = {index, reach2, lists, NULL, 0};
    for (uint32_t i = lists->first; i < lists->last; i++)
        wanted.max_k = MAX(wanted.max_k, list_start(lists, i + 1) -
                                             list_start(lists, i));
    if (wanted.max_k > 0)
        ask_for_all(&wanted, counts);
}
//<
//<

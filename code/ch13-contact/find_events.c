//> Find all events
// Threads take runs of pairs. An edge belongs to two triangles and a
// node to six, so an event of two edges is found up to four times: the
// lists are put together and sorted, and of equal ones one is kept.
// A pair that an axis separates costs up to 720 operations, one with an
// event several thousand.
#include "ch13-contact/find_events.h"
#include "ch13-contact/enlarge.h"
#include "ch13-contact/separating_axis.h"
#include <omp.h>
#include <stdlib.h>
#include <string.h>

//> Set a triangle in motion
struct moving_triangle moving_triangle_of(const struct scene *scene,
                                          uint32_t t)
{
    struct moving_triangle moving;
    for (int c = 0; c < 3; c++) {
        const uint32_t i = scene->mesh.corner[t][c];
        moving.node[c] = i;
        for (int k = 0; k < 3; k++) {
            moving.corner[c].begin[k] = scene->mesh.x[k][i];
            moving.corner[c].end[k] = scene->predicted[k][i];
        }
    }
    return moving;
}
//<

//> Name two edges in one way
static void swap_nodes(struct event *e, int i, int j)
{
    const uint32_t node = e->node[i];
    const double weight = e->weight[i];
    e->node[i] = e->node[j];
    e->weight[i] = e->weight[j];
    e->node[j] = node;
    e->weight[j] = weight;
}

static void name_edges(struct event *e)
{
    if (e->kind != EDGE_EDGE)
        return;
    if (e->node[0] > e->node[1])
        swap_nodes(e, 0, 1);
    if (e->node[2] > e->node[3])
        swap_nodes(e, 2, 3);
    if (e->node[0] > e->node[2] ||
        (e->node[0] == e->node[2] && e->node[1] > e->node[3])) {
        swap_nodes(e, 0, 2);
        swap_nodes(e, 1, 3);
    }
}
//<

//> Keep an event
static void keep_event(struct event_list *list, struct event event)
{
    if (list->count == list->room) {
        list->room = 2 * list->room + 64;
        list->event = enlarge(list->event, list->count, list->room,
                              sizeof *list->event);
    }
    name_edges(&event);
    list->event[list->count++] = event;
}
//<

//> Skip what has been tested
// Whether a node of these was stopped in this round, and one moves; in
// the first round nothing has been tested.
static bool is_wanted(const struct event_search *search,
                      struct pair pair)
{
    const struct scene *scene = search->scene;
    bool fresh = search->round == 1, moves = false;
    for (int c = 0; c < 6; c++) {
        const uint32_t t = c < 3 ? pair.one : pair.other;
        const uint32_t i = scene->mesh.corner[t][c % 3];
        fresh |= search->stopped_in_round[i] == search->round;
        moves |= search->stopped_in_round[i] == 0;
    }
    return fresh && moves;
}
//<

//> Test a pair for events
static void test_pair(const struct event_search *search,
                      struct pair pair, struct event_list *list)
{
    struct event event[MAX_EVENTS];
    const struct moving_triangle p =
        moving_triangle_of(search->scene, pair.one);
    const struct moving_triangle q =
        moving_triangle_of(search->scene, pair.other);
    list->pairs++;
    if (has_separating_axis(&p, &q, search->tolerance)) {
        list->apart++;
        return;
    }
    const size_t count = triangle_events(&p, &q, search->tolerance,
                                         event, &list->counts);
    for (size_t e = 0; e < count; e++)
        keep_event(list, event[e]);
    list->hits += count > 0;
}
//<

//> Compare two events
int compare_features(const struct event *a, const struct event *b)
{
    if (a->kind != b->kind)
        return (a->kind > b->kind) - (a->kind < b->kind);
    for (int k = 0; k < 4; k++)
        if (a->node[k] != b->node[k])
            return a->node[k] > b->node[k] ? 1 : -1;
    return 0;
}

// By all that they are: which of several equal ones is kept must not
// depend on which thread found it.
static int compare_events(const void *one, const void *other)
{
    const struct event *a = one, *b = other;
    const int features = compare_features(a, b);
    if (features != 0)
        return features;
    if (a->time != b->time)
        return a->time > b->time ? 1 : -1;
    for (int k = 0; k < 4; k++)
        if (a->weight[k] != b->weight[k])
            return a->weight[k] > b->weight[k] ? 1 : -1;
    for (int k = 0; k < 3; k++)
        if (a->point[k] != b->point[k])
            return a->point[k] > b->point[k] ? 1 : -1;
    return 0;
}
//<

//> Begin with empty lists
static void clear(struct event_list *list)
{
    *list = (struct event_list){list->event, .room = list->room};
}

static void begin_lists(struct events *events, int threads)
{
    if (threads > events->threads) {
        const int old = events->threads;
        const size_t size = sizeof *events->list;
        events->list = enlarge(events->list, old, threads, size);
        memset(events->list + old, 0, (threads - old) * size);
        events->threads = threads;
    }
    clear(&events->all);
    for (int k = 0; k < events->threads; k++)
        clear(&events->list[k]);
}
//<

//> Put the lists together
static void gather_lists(struct events *events)
{
    struct event_list *all = &events->all;
    for (int k = 0; k < events->threads; k++) {
        const struct event_list *list = &events->list[k];
        for (uint64_t e = 0; e < list->count; e++)
            keep_event(all, list->event[e]);
        all->hits += list->hits;
        all->pairs += list->pairs;
        all->apart += list->apart;
        all->counts.tests += list->counts.tests;
        all->counts.by_boxes += list->counts.by_boxes;
        all->counts.by_signs += list->counts.by_signs;
        all->counts.pieces += list->counts.pieces;
    }
    if (all->count > 1)
        qsort(all->event, all->count, sizeof *all->event,
              compare_events);
    uint64_t kept = 0;
    for (uint64_t e = 0; e < all->count; e++)
        if (kept == 0 || compare_features(&all->event[kept - 1],
                                          &all->event[e]) != 0)
            all->event[kept++] = all->event[e];
    all->count = kept;
}
//<

//> Search all pairs for events
void find_events(struct events *events,
                 const struct event_search *search)
{
    const struct pairs *pairs = search->pairs;
    begin_lists(events, search->threads);
#pragma omp parallel num_threads( \
    search->threads) if (search->threads > 1)
    {
        struct event_list *list = &events->list[omp_get_thread_num()];
#pragma omp for schedule(dynamic, 64) nowait
        for (uint64_t p = 0; p < pairs->count; p++)
            if (is_wanted(search, pairs->pair[p]))
                test_pair(search, pairs->pair[p], list);
    }
    gather_lists(events);
}
//<

void events_free(struct events *events)
{
    for (int k = 0; k < events->threads; k++)
        free(events->list[k].event);
    free(events->list);
    free(events->all.event);
    *events = (struct events){0};
}

//<

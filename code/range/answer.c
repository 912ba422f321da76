// Threads share the queries. Each has room for all points, so that no
// query asks for memory; what it found is copied, to its true length.
#include "range/answer.h"
#include "common/allocate.h"
#include "common/min_max.h"
#include "common/points.h"
#include <stdlib.h>
#include <string.h>

void place_of_query(const struct task *task, uint32_t q,
                    double place[MAX_DIMENSIONS])
{
    const struct queries *queries = &task->queries;
    for (int k = 0; k < task->points.d; k++)
        place[k] =
            queries->value
                ? queries->value[(size_t)q * queries->columns + k]
                : task->points.x[k][q];
}

struct range range_of_query(const struct task *task, uint32_t q)
{
    const int d = task->points.d;
    const double *row =
        task->queries.value + (size_t)q * task->queries.columns;
    struct range range = {0};
    for (int k = 0; k < d; k++) {
        range.low[k] = row[k];
        range.high[k] = row[d + k];
    }
    return range;
}

uint32_t self_of_query(const struct task *task, uint32_t q)
{
    return task->queries.value ? NO_INDEX : q;
}

// Room for what one query finds: points in a box, or neighbors.
struct room {
    uint32_t *point;
    struct found *found;
};

static int by_index(const void *one, const void *other)
{
    const uint32_t a = *(const uint32_t *)one;
    const uint32_t b = *(const uint32_t *)other;
    return (a > b) - (a < b);
}

static uint32_t answer_box(const struct task *task, uint32_t q,
                           const struct room *room,
                           struct totals *totals)
{
    const struct range range = range_of_query(task, q);
    struct report report = {room->point};
    task->structure->query(task->built, &range, &report);
    totals->steps += report.steps;
    totals->tested += report.tested;
    return report.count;
}

static uint32_t answer_place(const struct task *task, uint32_t q,
                             const struct room *room,
                             struct totals *totals)
{
    double place[MAX_DIMENSIONS];
    place_of_query(task, q, place);
    struct neighbor_query query = {.at = place,
                                   .self = self_of_query(task, q),
                                   .found = room->found};
    if (task->options->question == WITHIN)
        want_within(&query, task->options->distance);
    else
        want_nearest(&query, MIN(task->options->k, task->points.n));
    task->structure->neighbors(task->built, &query);
    totals->steps += query.steps;
    totals->tested += query.tested;
    return query.count;
}

// In the order in which they are written.
static struct answer keep_points(const uint32_t *point, uint32_t count)
{
    struct answer answer = {
        count, allocate(count, sizeof *answer.point), NULL};
    memcpy(answer.point, point, count * sizeof *point);
    qsort(answer.point, count, sizeof *answer.point, by_index);
    return answer;
}

static struct answer keep_neighbors(const struct task *task,
                                    struct found *found, uint32_t count)
{
    struct answer answer = {count,
                            allocate(count, sizeof *answer.point),
                            allocate(count, sizeof *answer.distance2)};
    if (task->options->question == WITHIN)
        sort_found(found, count);
    for (uint32_t k = 0; k < count; k++) {
        answer.point[k] = found[k].index;
        answer.distance2[k] = found[k].distance2;
    }
    return answer;
}

void answer_batch(const struct task *task, uint32_t first,
                  uint32_t last, struct answer *answer,
                  struct totals *totals)
{
    uint64_t found = 0, steps = 0, tested = 0;
    const bool boxes = task->options->question == BOXES;
    const uint32_t n = task->points.n;
#pragma omp parallel num_threads(task->threads) \
    reduction(+ : found, steps, tested)
    {
        struct room room = {0};
        if (boxes)
            room.point = allocate(n, sizeof *room.point);
        else
            room.found = allocate(n, sizeof *room.found);
        struct totals mine = {0};
#pragma omp for schedule(dynamic, 16)
        for (uint32_t q = first; q < last; q++) {
            const uint32_t count =
                boxes ? answer_box(task, q, &room, &mine)
                      : answer_place(task, q, &room, &mine);
            mine.found += count;
            if (answer)
                answer[q - first] =
                    boxes ? keep_points(room.point, count)
                          : keep_neighbors(task, room.found, count);
        }
        found = mine.found;
        steps = mine.steps;
        tested = mine.tested;
        free(room.point);
        free(room.found);
    }
    totals->found += found;
    totals->steps += steps;
    totals->tested += tested;
}

void answers_release(struct answer *answer, uint32_t count)
{
    for (uint32_t k = 0; k < count; k++) {
        free(answer[k].point);
        free(answer[k].distance2);
    }
}

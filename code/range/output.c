// See output.h. The check knows no structure: it asks of every point
// whether it should have been found.
#include "range/output.h"
#include "common/allocate.h"
#include "common/numbers.h"
#include "near/write.h"
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void write_text(const char *text)
{
    write_bytes(text, strlen(text));
}

void write_head(const struct task *task)
{
    if (task->options->counts)
        write_text("query\tcount\n");
    else if (task->options->question == BOXES)
        write_text("query\tpoint\n");
    else
        write_text("query\tpoint\tdistance\n");
}

static void write_neighbor(uint32_t q, const struct answer *answer,
                           uint32_t k)
{
    char line[32 + LONGEST_NUMBER];
    int used = snprintf(line, sizeof line, "%" PRIu32 "\t%" PRIu32, q,
                        answer->point[k]);
    char *end = line + used;
    if (answer->distance2) {
        *end++ = '\t';
        end = number_to_text(end, sqrt(answer->distance2[k]));
    }
    *end++ = '\n';
    write_bytes(line, end - line);
}

void write_answers(const struct task *task, uint32_t first,
                   const struct answer *answer, uint32_t count)
{
    for (uint32_t q = 0; q < count; q++) {
        char line[32];
        if (task->options->counts) {
            snprintf(line, sizeof line, "%" PRIu32 "\t%" PRIu32 "\n",
                     first + q, answer[q].count);
            write_text(line);
            continue;
        }
        for (uint32_t k = 0; k < answer[q].count; k++)
            write_neighbor(first + q, &answer[q], k);
    }
}

// ---- the check -----------------------------------------------------
static bool in_box(const struct point_set *p, uint32_t i,
                   const struct range *box)
{
    bool in = true;
    for (int k = 0; k < p->d; k++)
        in &= p->x[k][i] >= box->low[k] && p->x[k][i] <= box->high[k];
    return in;
}

static double distance2_of(const struct point_set *p, uint32_t i,
                           const double *place)
{
    double sum = 0;
    for (int k = 0; k < p->d; k++)
        sum += (place[k] - p->x[k][i]) * (place[k] - p->x[k][i]);
    return sum;
}

// A box's answer is in the order of the points.
static bool box_is_right(const struct task *task, uint32_t q,
                         const struct answer *answer)
{
    const struct range box = range_of_query(task, q);
    uint32_t k = 0;
    for (uint32_t i = 0; i < task->points.n; i++)
        if (in_box(&task->points, i, &box) &&
            (k == answer->count || answer->point[k++] != i))
            return false;
    return k == answer->count;
}

// Right are distances that are true and do not fall, points of which
// none comes twice, and just as many as there must be: within the
// distance, or nearer than the last.
static bool place_is_right(const struct task *task, uint32_t q,
                           const struct answer *answer)
{
    const struct options *o = task->options;
    const uint32_t n = task->points.n, self = self_of_query(task, q);
    const uint32_t others = n - (self < n), count = answer->count;
    double place[MAX_DIMENSIONS];
    place_of_query(task, q, place);
    for (uint32_t k = 0; k < count; k++) {
        const uint32_t i = answer->point[k];
        const bool follows =
            k == 0 || answer->distance2[k - 1] < answer->distance2[k] ||
            (answer->distance2[k - 1] == answer->distance2[k] &&
             answer->point[k - 1] < i);
        if (i >= n || i == self || !follows ||
            distance2_of(&task->points, i, place) !=
                answer->distance2[k])
            return false;
    }
    const bool within = o->question == WITHIN;
    if (!within && count != (o->k < others ? o->k : others))
        return false;
    const double reach2 = within  ? o->distance * o->distance
                          : count ? answer->distance2[count - 1]
                                  : 0;
    uint32_t there = 0, nearer = 0;
    for (uint32_t i = 0; i < n; i++) {
        const double apart2 = distance2_of(&task->points, i, place);
        there += i != self && apart2 <= reach2;
        nearer += i != self && apart2 < reach2;
    }
    return within ? there == count : nearer <= count && count <= there;
}

uint32_t count_wrong(const struct task *task, uint32_t first,
                     const struct answer *answer, uint32_t count)
{
    uint32_t wrong = 0;
#pragma omp parallel for num_threads(task->threads) \
    reduction(+ : wrong) schedule(dynamic)
    for (uint32_t q = 0; q < count; q++)
        wrong += task->options->question == BOXES
                     ? !box_is_right(task, first + q, &answer[q])
                     : !place_is_right(task, first + q, &answer[q]);
    return wrong;
}

// Writes a piece of rows at a time, each formatted by a thread and
// written when its turn has come. The check measures all n^2 pairs, as
// often as a list needs, and shares nothing with the search.
#include "near/lists.h"
#include "common/allocate.h"
#include "common/min_max.h"
#include "common/numbers.h"
#include "near/progress.h"
#include "near/put.h"
#include "near/write.h"
#include <math.h>
#include <stdlib.h>

enum { PIECE = 4096, LONGEST_ROW = 2 * 11 + LONGEST_NUMBER + 1 };

void write_lists_head(enum table_kind kind, bool counts, uint64_t rows)
{
    static const struct put_column columns[] = {
        {"i", "<u4"}, {"neighbor", "<u4"}, {"distance", "<f8"}};
    static const struct put_column two[] = {{"i", "<u4"},
                                            {"count", "<u4"}};
    const struct put_column *chosen = counts ? two : columns;
    char head[512];
    char *end = kind == TEXT_TABLE
                    ? put_names(head, chosen, counts ? 2 : 3)
                    : put_npy_head(head, chosen, counts ? 2 : 3, rows);
    write_bytes(head, end - head);
}

static char *put_row(char *to, enum table_kind kind, uint32_t i,
                     uint32_t neighbor, double distance2)
{
    const double distance = sqrt(distance2);
    if (kind == NPY_TABLE) {
        to = put_bytes(to, &i, sizeof i);
        to = put_bytes(to, &neighbor, sizeof neighbor);
        return put_bytes(to, &distance, sizeof distance);
    }
    to = put_count(to, i);
    *to++ = '\t';
    to = put_count(to, neighbor);
    *to++ = '\t';
    to = number_to_text(to, distance);
    *to++ = '\n';
    return to;
}

// The list that has this place of the arrays.
static uint32_t list_of(const struct neighbor_lists *lists,
                        uint64_t place)
{
    uint32_t low = lists->first, high = lists->last;
    while (high - low > 1) {
        const uint32_t middle = low + (high - low) / 2;
        if (list_start(lists, middle) <= place)
            low = middle;
        else
            high = middle;
    }
    return low;
}

static char *put_stretch(char *to, enum table_kind kind,
                         const struct neighbor_lists *lists,
                         uint64_t place, uint64_t stop)
{
    uint32_t i = list_of(lists, place);
    for (; place < stop; place++) {
        while (list_start(lists, i + 1) <= place)
            i++;
        to = put_row(to, kind, i, lists->index[place],
                     lists->distance2[place]);
    }
    return to;
}

void write_lists(enum table_kind kind,
                 const struct neighbor_lists *lists, int threads)
{
    const uint64_t rows = list_start(lists, lists->last);
#pragma omp parallel num_threads(threads)
    {
        char *bytes = allocate(PIECE, LONGEST_ROW);
#pragma omp for ordered schedule(dynamic)
        for (uint64_t k = 0; k < rows; k += PIECE) {
            const char *end = put_stretch(bytes, kind, lists, k,
                                          k + MIN(rows - k, PIECE));
#pragma omp ordered
            write_bytes(bytes, end - bytes);
        }
        free(bytes);
    }
}

void write_counts(enum table_kind kind, const uint32_t *count,
                  uint32_t n)
{
    char row[2 * 11 + 1], *end;
    for (uint32_t i = 0; i < n; i++) {
        if (kind == NPY_TABLE) {
            end = put_bytes(row, &i, sizeof i);
            end = put_bytes(end, &count[i], sizeof count[i]);
        } else {
            end = put_count(row, i);
            *end++ = '\t';
            end = put_count(end, count[i]);
            *end++ = '\n';
        }
        write_bytes(row, end - row);
    }
}

// ---- the check -----------------------------------------------------
static double apart2(const struct question *question, uint32_t i,
                     uint32_t j)
{
    const struct points p = question->points;
    return closest2(question->space, p.x[i] - p.x[j], p.y[i] - p.y[j]);
}

// How many points are before a distance and an index, or at it.
static uint32_t up_to(const struct question *question, uint32_t i,
                      double reach2, uint32_t last)
{
    uint32_t there = 0;
    for (uint32_t j = 0; j < question->points.n; j++) {
        const double d2 = apart2(question, i, j);
        there += j != i && (d2 < reach2 || (d2 == reach2 && j <= last));
    }
    return there;
}

static bool list_is_right(const struct question *question,
                          double reach2,
                          const struct neighbor_lists *lists,
                          uint32_t i)
{
    const uint64_t start = list_start(lists, i);
    const uint32_t n = question->points.n;
    const uint32_t count = list_start(lists, i + 1) - start;
    const uint32_t *index = lists->index + start;
    const double *d2 = lists->distance2 + start;
    for (uint32_t k = 0; k < count; k++) {
        const bool follows =
            k == 0 || d2[k - 1] < d2[k] ||
            (d2[k - 1] == d2[k] && index[k - 1] < index[k]);
        if (index[k] >= n || index[k] == i || !follows ||
            apart2(question, i, index[k]) != d2[k])
            return false;
    }
    if (reach2 < INFINITY)
        return up_to(question, i, reach2, n) == count;
    return count == 0 ||
           up_to(question, i, d2[count - 1], index[count - 1]) == count;
}

uint32_t check_lists(const struct question *question, double reach2,
                     const struct neighbor_lists *lists,
                     uint32_t *first_wrong)
{
    uint32_t wrong = 0, first = NO_INDEX;
#pragma omp parallel for schedule(dynamic, 32) \
    num_threads(question->threads) reduction(+ : wrong) \
    reduction(min : first)
    for (uint32_t i = lists->first; i < lists->last; i++) {
        if (!list_is_right(question, reach2, lists, i)) {
            wrong++;
            first = MIN(first, i);
        }
        progress_rows(1);
    }
    *first_wrong = MIN(*first_wrong, first);
    return wrong;
}

uint32_t check_counts(const struct question *question, double reach2,
                      const uint32_t *count, uint32_t *first_wrong)
{
    uint32_t wrong = 0, first = NO_INDEX;
#pragma omp parallel for schedule(dynamic, 32) \
    num_threads(question->threads) reduction(+ : wrong) \
    reduction(min : first)
    for (uint32_t i = 0; i < question->points.n; i++) {
        if (up_to(question, i, reach2, NO_INDEX) != count[i]) {
            wrong++;
            first = MIN(first, i);
        }
        progress_rows(1);
    }
    *first_wrong = MIN(*first_wrong, first);
    return wrong;
}

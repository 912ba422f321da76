//> Keep the list of the k nearest
// A short list is put in order by insertion, a long one is sorted as a
// whole: when as many were appended as it keeps, so that m candidates
// take O(m log k) steps, and once at the end of each piece.
#include "ch12-range-queries/k_nearest_list.h"
#include "ch12-range-queries/point_set.h"
#include "common/allocate.h"
#include "common/min_max.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SHORT = 32 };

struct k_nearest_list k_nearest_list_make(size_t k)
{
    const size_t room = 2 * k + 2 * MAX_APPENDED;
    return (struct k_nearest_list){
        .k = (uint32_t)k,
        .room = room,
        .found = allocate(room, sizeof(struct found))};
}

void k_nearest_list_free(struct k_nearest_list *list)
{
    free(list->found);
}

void k_nearest_list_clear(struct k_nearest_list *list, uint32_t self,
                          double reach2)
{
    list->self = self;
    list->reach2 = reach2;
    list->count = list->ordered = 0;
}

//> Insert what was appended
static void insert_all(struct k_nearest_list *list)
{
    size_t kept = list->ordered;
    for (size_t next = kept; next < list->count; next++)
        kept = insert_nearest(list->found, kept, list->k,
                              list->found[next]);
    list->count = kept;
}
//<

//> Rank all at once
// The rank of each is the number of those that are nearer, counted with
// one comparison for every pair, in lanes and without a branch. If two
// are equally far, ranks add up to less than 0 + 1 + 2 + ..., and
// nothing is done.
enum { RANKED = 64 };

static size_t rank_of(const double *distance2, size_t padded, double d2)
{
    uint64_t rank = 0;
#pragma omp simd reduction(+ : rank)
    for (size_t j = 0; j < padded; j++)
        rank += distance2[j] < d2;
    return rank;
}

static bool rank_all(struct k_nearest_list *list)
{
    const size_t n = list->count;
    const size_t padded = (n + LANES - 1) / LANES * LANES;
    double distance2[RANKED];
    struct found sorted[RANKED];
    size_t sum = 0;
    for (size_t i = 0; i < padded; i++)
        distance2[i] = i < n ? list->found[i].distance2 : INFINITY;
    for (size_t i = 0; i < n; i++) {
        const size_t rank = rank_of(distance2, padded, distance2[i]);
        sorted[rank] = list->found[i];
        sum += rank;
    }
    if (sum != n * (n - 1) / 2)
        return false;
    list->count = MIN(n, list->k);
    memcpy(list->found, sorted, list->count * sizeof *sorted);
    return true;
}
//<

//> Sort what was appended
static int nearer_first(const void *one, const void *other)
{
    const struct found *a = one, *b = other;
    return is_nearer(*b, *a) - is_nearer(*a, *b);
}

void sort_found(struct found *found, size_t count)
{
    qsort(found, count, sizeof *found, nearer_first);
}

static void sort_all(struct k_nearest_list *list)
{
    sort_found(list->found, list->count);
    list->count = MIN(list->count, list->k);
}
//<

//> Keep the k nearest
void keep_k_nearest(struct k_nearest_list *list)
{
    if (list->count == list->ordered)
        return;
    if (list->k > SHORT)
        sort_all(list);
    else if (list->ordered > 0 || list->count > RANKED ||
             !rank_all(list))
        insert_all(list);
    list->ordered = list->count;
    if (list->count == list->k)
        list->reach2 =
            MIN(list->reach2, list->found[list->k - 1].distance2);
}
//<
//<

//> Bring pairs into order
// Count, scan, place, as in chapter 4: how many pairs each triangle
// has, where they begin, and each to its place. Within a triangle they
// lie as the threads came, and are then sorted; so the order is the
// same for any broad phase and any number of threads.
#include "ch13-contact/pairs.h"
#include "ch13-contact/enlarge.h"
#include "common/min_max.h"
#include <stdlib.h>
#include <string.h>

//> Keep a list for each thread
void pairs_begin(struct pairs *pairs, int threads)
{
    if (threads > pairs->threads) {
        const int old = pairs->threads;
        const size_t size = sizeof *pairs->list;
        pairs->list = enlarge(pairs->list, old, threads, size);
        memset(pairs->list + old, 0, (threads - old) * size);
        pairs->threads = threads;
    }
    for (int k = 0; k < pairs->threads; k++)
        pairs->list[k].count = pairs->list[k].tested = 0;
    pairs->count = pairs->tested = 0;
}

void pair_list_grow(struct pair_list *list)
{
    list->room = 2 * list->room + 1024;
    list->pair = enlarge(list->pair, list->count, list->room,
                         sizeof *list->pair);
}
//<

void pairs_free(struct pairs *pairs)
{
    for (int k = 0; k < pairs->threads; k++)
        free(pairs->list[k].pair);
    free(pairs->list);
    free(pairs->pair);
    free(pairs->start);
    *pairs = (struct pairs){0};
}

//> Make room for the gathered pairs
static void reserve(struct pairs *pairs, uint32_t n)
{
    if (n > pairs->triangles || !pairs->start) {
        free(pairs->start);
        pairs->start = allocate((size_t)n + 1, sizeof *pairs->start);
        pairs->triangles = n;
    }
    for (int k = 0; k < pairs->threads; k++) {
        pairs->count += pairs->list[k].count;
        pairs->tested += pairs->list[k].tested;
    }
    if (pairs->count > pairs->room) {
        free(pairs->pair);
        pairs->room = pairs->count + pairs->count / 2;
        pairs->pair = allocate(pairs->room, sizeof *pairs->pair);
    }
}
//<

//> Count and scan the pairs of each triangle
// Afterwards start[t + 1] is where the pairs of triangle t begin.
static void count_pairs(struct pairs *pairs, uint32_t n)
{
    uint64_t *start = pairs->start, sum = 0;
    memset(start, 0, ((size_t)n + 1) * sizeof *start);
#pragma omp parallel for num_threads( \
    pairs->threads) if (pairs->threads > 1)
    for (int k = 0; k < pairs->threads; k++)
        for (uint64_t p = 0; p < pairs->list[k].count; p++) {
            const uint32_t one = pairs->list[k].pair[p].one;
#pragma omp atomic
            start[one + 1]++;
        }
    for (uint32_t t = 0; t < n; t++) {
        const uint64_t count = start[t + 1];
        start[t + 1] = sum;
        sum += count;
    }
}
//<

//> Place the pairs
// Each that is placed moves the place of the next: in the end
// start[t + 1] is where the pairs of triangle t end.
static void place_pairs(struct pairs *pairs)
{
#pragma omp parallel for num_threads( \
    pairs->threads) if (pairs->threads > 1)
    for (int k = 0; k < pairs->threads; k++)
        for (uint64_t p = 0; p < pairs->list[k].count; p++) {
            const struct pair pair = pairs->list[k].pair[p];
            uint64_t place;
#pragma omp atomic capture
            place = pairs->start[pair.one + 1]++;
            pairs->pair[place] = pair;
        }
}
//<

//> Sort the pairs of a triangle
// By insertion, as long as they are few.
static int by_other(const void *a, const void *b)
{
    const uint32_t i = ((const struct pair *)a)->other;
    const uint32_t j = ((const struct pair *)b)->other;
    return (i > j) - (i < j);
}

static void sort_row(struct pair *pair, uint64_t count)
{
    enum { FEW = 64 };
    if (count > FEW) {
        qsort(pair, count, sizeof *pair, by_other);
        return;
    }
    for (uint64_t p = 1; p < count; p++) {
        const struct pair moved = pair[p];
        uint64_t place = p;
        for (; place > 0 && pair[place - 1].other > moved.other;
             place--)
            pair[place] = pair[place - 1];
        pair[place] = moved;
    }
}
//<
//<

//> Gather the pairs
void pairs_gather(struct pairs *pairs, uint32_t n)
{
    reserve(pairs, n);
    count_pairs(pairs, n);
    place_pairs(pairs);
#pragma omp parallel for num_threads( \
    pairs->threads) if (pairs->threads > 1) schedule(dynamic, 1024)
    for (uint32_t t = 0; t < n; t++)
        sort_row(pairs->pair + pairs->start[t],
                 pairs->start[t + 1] - pairs->start[t]);
}
//<

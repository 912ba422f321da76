//> Sort by keys
// Count, scan, place, as the cell sort of chapter 4 on one axis; then
// bucket by bucket.
#include "ch10-furthest/sort_keys.h"
#include "ch04-cell-sort/cells.h"
#include "common/min_max.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

//> Order two keys
static int by_key(const void *one, const void *other)
{
    const struct keyed *a = one, *b = other;
    if (a->key != b->key)
        return a->key < b->key ? -1 : 1;
    return (a->number > b->number) - (a->number < b->number);
}
//<

//> Sort one bucket of keys
// Mostly of one, two or three.
static void sort_bucket(struct keyed *bucket, uint32_t n)
{
    enum { FEW = 12 };
    if (n > FEW) {
        qsort(bucket, n, sizeof *bucket, by_key);
        return;
    }
    for (uint32_t k = 1; k < n; k++) {
        const struct keyed next = bucket[k];
        uint32_t at = k;
        for (; at > 0 && by_key(&bucket[at - 1], &next) > 0; at--)
            bucket[at] = bucket[at - 1];
        bucket[at] = next;
    }
}
//<

//> Find the bucket of a key
struct buckets {
    double low, scale;
    uint32_t last;
};

static struct buckets buckets_for(const struct keyed *keyed, uint32_t n)
{
    double low = INFINITY, high = -INFINITY;
    for (uint32_t k = 0; k < n; k++) {
        low = MIN(keyed[k].key, low);
        high = MAX(keyed[k].key, high);
    }
    const double scale = n / (high - low);
    return (struct buckets){low, isfinite(scale) ? scale : 0, n - 1};
}

static inline uint32_t bucket_of(const struct buckets *buckets,
                                 double key)
{
    const double at = (key - buckets->low) * buckets->scale;
    return at < buckets->last ? (uint32_t)at : buckets->last;
}
//<

//> Sort in buckets
void sort_keys(const struct keyed *keyed, uint32_t n,
               struct keyed *sorted, struct workspace *workspace)
{
    struct mark mark = workspace_mark(workspace);
    const struct buckets buckets = buckets_for(keyed, n);
    uint32_t *end = workspace_take(workspace, n, sizeof *end);
    memset(end, 0, n * sizeof *end);
    for (uint32_t k = 0; k < n; k++)
        end[bucket_of(&buckets, keyed[k].key)]++;
    cells_scan(end, n, 0);
    for (uint32_t k = 0; k < n; k++)
        sorted[end[bucket_of(&buckets, keyed[k].key)]++] = keyed[k];
    for (uint32_t b = 0, begin = 0; b < n; begin = end[b++])
        if (end[b] - begin > 1)
            sort_bucket(sorted + begin, end[b] - begin);
    workspace_release(workspace, mark);
}
//<
//<

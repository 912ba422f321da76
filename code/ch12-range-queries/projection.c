//> Project the points on every axis
// References are sorted by radix, repaired by insertion, and searched
// by halving. 4 d n bytes; to build, d sorts.
#include "ch12-range-queries/projection.h"
#include "ch12-range-queries/order.h"
#include "common/allocate.h"
#include <stdlib.h>

struct projection projection_make(const struct point_set *points)
{
    struct projection projection = {*points};
    const uint32_t n = points->n;
    struct radix_record *room = allocate(2 * (size_t)n, sizeof *room);
    for (int k = 0; k < points->d; k++) {
        projection.order[k] = allocate(n, sizeof(uint32_t));
        sort_order(points->x[k], projection.order[k], n, room);
    }
    free(room);
    return projection;
}

void projection_free(struct projection *projection)
{
    for (int k = 0; k < projection->points.d; k++)
        free(projection->order[k]);
    *projection = (struct projection){0};
}

size_t projection_bytes(const struct projection *projection)
{
    return (size_t)projection->points.n * projection->points.d *
           sizeof(uint32_t);
}

uint64_t projection_update(struct projection *projection)
{
    const struct point_set *points = &projection->points;
    const uint32_t n = points->n;
    struct radix_record *room = allocate(2 * (size_t)n, sizeof *room);
    uint64_t shifts = 0;
    for (int k = 0; k < points->d; k++)
        shifts +=
            repair_order(points->x[k], projection->order[k], n, room);
    free(room);
    return shifts;
}

//> Find a place by halves
struct slice {
    const uint32_t *order; // of the coordinate
    uint32_t begin, end;   // order[begin .. end - 1]
};

// The first place whose number is not below, or with strictly, that is
// above the value.
static uint32_t place_of(const double *x, const uint32_t *order,
                         uint32_t n, double value, bool strictly)
{
    uint32_t low = 0, high = n;
    while (low < high) {
        const uint32_t middle = low + (high - low) / 2;
        const double here = x[order[middle]];
        if (here < value || (strictly && here == value))
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}
//<

//> Find the slice of a coordinate
static struct slice slice_of(const struct projection *projection, int k,
                             const struct range *range)
{
    const uint32_t n = projection->points.n;
    const uint32_t *order = projection->order[k];
    const double *x = projection->points.x[k];
    return (struct slice){order,
                          place_of(x, order, n, range->low[k], false),
                          place_of(x, order, n, range->high[k], true)};
}
//<

//> Look at the smallest slice
static uint32_t length_of(struct slice slice)
{
    return slice.end > slice.begin ? slice.end - slice.begin : 0;
}

void projection_query(const struct projection *projection,
                      const struct range *range, struct report *report)
{
    const struct point_set *points = &projection->points;
    struct slice fewest = slice_of(projection, 0, range);
    for (int k = 1; k < points->d; k++) {
        const struct slice slice = slice_of(projection, k, range);
        if (length_of(slice) < length_of(fewest))
            fewest = slice;
    }
    for (uint32_t r = fewest.begin; r < fewest.end; r++)
        if (is_inside(points, fewest.order[r], range))
            report->found[report->count++] = fewest.order[r];
    for (uint32_t n = points->n; n > 0; n /= 2)
        report->steps += 2 * points->d;
    report->tested += length_of(fewest);
}
//<
//<

//> Project the points on every axis
// References are sorted by radix, repaired by insertion, and searched
// by halving. 4 d n bytes; to build, d sorts.
#include "ch12-range-queries/projection.h"
#include "ch12-range-queries/radix_sort.h"
#include "common/allocate.h"
#include <stdlib.h>

//> Sort the references
static void sort_by(const double *x, uint32_t n, uint32_t *order)
{
    struct radix_record *record = allocate(n, sizeof *record);
    struct radix_record *room = allocate(n, sizeof *room);
    for (uint32_t i = 0; i < n; i++)
        record[i] = (struct radix_record){radix_key(x[i]), i};
    radix_sort(record, n, 64, room);
    for (uint32_t r = 0; r < n; r++)
        order[r] = record[r].point;
    free(record);
    free(room);
}

struct projection projection_make(const struct point_set *points)
{
    struct projection projection = {*points};
    const uint32_t n = points->n;
    for (int k = 0; k < points->d; k++) {
        projection.order[k] = allocate(n, sizeof(uint32_t));
        sort_by(points->x[k], n, projection.order[k]);
    }
    return projection;
}
//<

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

//> Repair the order
// By insertion: a reference goes past those with a greater number,
// which are shifted by a place. Gives up after so many shifts.
static uint64_t insert_all(const double *x, uint32_t n, uint32_t *order)
{
    const uint64_t max_shifts = (uint64_t)MAX_SHIFTS * n;
    uint64_t shifts = 0;
    for (uint32_t r = 1; r < n && shifts <= max_shifts; r++) {
        const uint32_t point = order[r];
        uint32_t place = r;
        for (; place > 0 && x[order[place - 1]] > x[point]; place--)
            order[place] = order[place - 1];
        order[place] = point;
        shifts += r - place;
    }
    if (shifts > max_shifts)
        sort_by(x, n, order);
    return shifts;
}

uint64_t projection_update(struct projection *projection)
{
    const struct point_set *points = &projection->points;
    uint64_t shifts = 0;
    for (int k = 0; k < points->d; k++)
        shifts +=
            insert_all(points->x[k], points->n, projection->order[k]);
    return shifts;
}
//<

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

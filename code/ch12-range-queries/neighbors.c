//> Keep the neighbors
// The nearest are kept sorted, by insertion: k steps for each that
// comes in, which few do.
#include "ch12-range-queries/neighbors.h"
#include "common/allocate.h"
#include "common/min_max.h"
#include "common/points.h"
#include <math.h>
#include <stdlib.h>

void want_nearest(struct neighbors *query, uint32_t k)
{
    query->nearest = true;
    query->k = k;
    query->reach2 = INFINITY;
    query->count = 0;
}

void want_within(struct neighbors *query, double distance)
{
    query->nearest = false;
    query->reach2 = distance * distance;
    query->count = 0;
}

//> Measure several distances at once
static inline void measure(const struct point_set *points, uint32_t i,
                           const double *at, double distance2[LANES])
{
    for (int lane = 0; lane < LANES; lane++)
        distance2[lane] = 0;
    for (int k = 0; k < points->d; k++) {
        const double *x = points->x[k] + i;
        for (int lane = 0; lane < LANES; lane++) {
            const double apart = x[lane] - at[k];
            distance2[lane] += apart * apart;
        }
    }
}
//<

//> Insert a neighbor
static bool is_closer(double a2, uint32_t a, double b2, uint32_t b)
{
    return a2 < b2 || (a2 == b2 && a < b);
}

static void insert(struct neighbors *query, double distance2,
                   uint32_t point)
{
    uint32_t place = query->count;
    if (place < query->k)
        query->count++;
    else if (!is_closer(distance2, point, query->distance2[place - 1],
                        query->point[place - 1]))
        return;
    else
        place--;
    for (; place > 0 &&
           is_closer(distance2, point, query->distance2[place - 1],
                     query->point[place - 1]);
         place--) {
        query->distance2[place] = query->distance2[place - 1];
        query->point[place] = query->point[place - 1];
    }
    query->distance2[place] = distance2;
    query->point[place] = point;
    if (query->count == query->k)
        query->reach2 = query->distance2[query->k - 1];
}
//<

//> Take a candidate
static inline void take_one(struct neighbors *query, double distance2,
                            uint32_t point)
{
    if (point == query->self)
        return;
    if (query->nearest) {
        insert(query, distance2, point);
    } else {
        query->point[query->count] = point;
        query->distance2[query->count++] = distance2;
    }
}
//<

//> Take a stretch of candidates
void take_neighbors(const struct sorted_points *sorted, uint32_t begin,
                    uint32_t end, struct neighbors *query)
{
    for (uint32_t s = begin; s < end; s += LANES) {
        double distance2[LANES];
        measure(&sorted->points, s, query->at, distance2);
        const uint32_t some = MIN(end - s, LANES);
        for (uint32_t lane = 0; lane < some; lane++)
            if (distance2[lane] <= query->reach2)
                take_one(query, distance2[lane],
                         sorted->index[s + lane]);
    }
    query->tested += end - begin;
}
//<

void scan_neighbors(const struct point_set *points,
                    struct neighbors *query)
{
    for (uint32_t i = 0; i < points->n; i++) {
        double distance2 = 0;
        for (int k = 0; k < points->d; k++) {
            const double apart = points->x[k][i] - query->at[k];
            distance2 += apart * apart;
        }
        if (distance2 <= query->reach2)
            take_one(query, distance2, i);
    }
    query->tested += points->n;
}

//> Put neighbors in order
struct neighbor {
    double distance2;
    uint32_t point;
};

static int from_near(const void *one, const void *other)
{
    const struct neighbor *a = one, *b = other;
    return is_closer(a->distance2, a->point, b->distance2, b->point)
               ? -1
               : 1;
}

void sort_neighbors(struct neighbors *query)
{
    const uint32_t n = query->count;
    struct neighbor *sorted = allocate(n, sizeof *sorted);
    for (uint32_t k = 0; k < n; k++)
        sorted[k] =
            (struct neighbor){query->distance2[k], query->point[k]};
    qsort(sorted, n, sizeof *sorted, from_near);
    for (uint32_t k = 0; k < n; k++) {
        query->distance2[k] = sorted[k].distance2;
        query->point[k] = sorted[k].point;
    }
    free(sorted);
}
//<
//<

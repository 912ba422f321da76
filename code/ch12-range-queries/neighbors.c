//> Keep the neighbors
// The nearest are kept sorted, by insertion: k steps for each that
// comes in, which few do.
#include "ch12-range-queries/neighbors.h"
#include "common/min_max.h"
#include <math.h>

void want_nearest(struct neighbor_query *query, uint32_t k)
{
    query->nearest = true;
    query->k = k;
    query->reach2 = INFINITY;
    query->count = 0;
}

void want_within(struct neighbor_query *query, double distance)
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

//> Take a candidate
static inline void take_one(struct neighbor_query *query,
                            struct found one)
{
    if (one.index == query->self)
        return;
    if (!query->nearest) {
        query->found[query->count++] = one;
        return;
    }
    query->count = (uint32_t)insert_nearest(query->found, query->count,
                                            query->k, one);
    if (query->count == query->k)
        query->reach2 = query->found[query->k - 1].distance2;
}
//<

//> Take a stretch of candidates
void take_neighbors(const struct sorted_points *sorted, uint32_t begin,
                    uint32_t end, struct neighbor_query *query)
{
    for (uint32_t s = begin; s < end; s += LANES) {
        double distance2[LANES];
        measure(&sorted->points, s, query->at, distance2);
        const uint32_t some = MIN(end - s, LANES);
        for (uint32_t lane = 0; lane < some; lane++)
            if (distance2[lane] <= query->reach2)
                take_one(query,
                         (struct found){distance2[lane],
                                        sorted->index[s + lane]});
    }
    query->tested += end - begin;
}
//<

void scan_neighbors(const struct point_set *points,
                    struct neighbor_query *query)
{
    for (uint32_t i = 0; i < points->n; i++) {
        double distance2 = 0;
        for (int k = 0; k < points->d; k++) {
            const double apart = points->x[k][i] - query->at[k];
            distance2 += apart * apart;
        }
        if (distance2 <= query->reach2)
            take_one(query, (struct found){distance2, i});
    }
    query->tested += points->n;
}
//<

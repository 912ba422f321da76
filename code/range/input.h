// The points and the queries that range is asked about.
#pragma once
#include "range/options.h"

// Of the file, or generated; released with point_set_free.
struct point_set get_point_set(const struct options *options);

// Queries, a row each: places, or boxes, all lows before all highs.
struct queries {
    uint32_t count;
    int columns;   // d or 2 d
    double *value; // NULL: the points themselves
};

// Of the file, or random inside the range of the points; places may
// also be the points themselves. Released with free(queries.value).
struct queries get_queries(const struct options *options,
                           const struct point_set *points);

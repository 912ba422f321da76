//> Declare the neighbors in the plane
// For all points of the plane, or some that follow each other in the
// input: the k nearest, all within a distance, or how many these are.
// Queries run in the order of the cells, by the index's threads, and
// write where their point's answer belongs. A point is not its own
// neighbor. Of equally far ones, the lower index comes first.
#pragma once
#include "ch12-range-queries/plane_index.h"

//> Hold lists of neighbors
// Of the points first .. last - 1, one after the other: each has as
// many neighbors, or start[i - first] says where those of point i
// begin, and start[i - first + 1] where they end. The nearest first.
struct neighbor_lists {
    uint32_t first, last;
    uint32_t each;
    const uint64_t *start; // [last - first + 1], or NULL
    uint32_t *index;
    double *distance2; // squared
};

static inline uint64_t list_start(const struct neighbor_lists *lists,
                                  uint32_t i)
{
    const uint32_t at = i - lists->first;
    return lists->start ? lists->start[at] : (uint64_t)at * lists->each;
}
//<

// How many neighbors each point has within a distance, squared, itself
// left out: count[0 .. n-1].
void count_plane_within(const struct plane_index *index, double reach2,
                        uint32_t *count, struct counts *counts);

// Fills lists that have room: with as many of the nearest as there is
// room for, no more than n - 1, if reach2 is INFINITY; or with all
// within a distance, if there is room for just these.
void fill_plane_lists(const struct plane_index *index, double reach2,
                      const struct neighbor_lists *lists,
                      struct counts *counts);
//<

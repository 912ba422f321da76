//> Declare the table of structures
// Whatever is in the table is in range --list, and is run by every test
// of this chapter.
#pragma once
#include "ch12-range-queries/neighbors.h"
#include "ch12-range-queries/scan.h"

//> Describe a structure
// What is built belongs to the caller, who gives it to discard; the
// points must stay until then. neighbors, walk_order and update are
// NULL where a structure has no such thing.
struct structure {
    const char *name;  // as in range -a NAME
    const char *about; // one line for range --list
    void *(*build)(const struct point_set *points, int threads);
    // The points have moved: same n, same d, same arrays.
    void (*update)(void *built, const struct point_set *points);
    void (*query)(const void *built, const struct range *range,
                  struct report *report);
    void (*neighbors)(const void *built, struct neighbor_query *query);
    // An order of the points in which neighbors follow each other.
    const struct sorted_points *(*walk_order)(const void *built);
    size_t (*bytes)(const void *built);
    void (*discard)(void *built);
};
//<

extern const struct structure structures[];
extern const int structure_count;

// NULL if there is no such structure.
const struct structure *find_structure(const char *name);

// Brings what is built in line with points that have moved: updates it,
// or discards it and builds another. Returns what there is then.
void *structure_update(const struct structure *structure, void *built,
                       const struct point_set *points, int threads);

// The k nearest of each of the points but itself, so many threads at a
// time: those of point i from nearest[i k] and nearest2[i k] on. There
// must be more than k points.
void k_nearest_of_all(const struct structure *structure,
                      const void *built, uint32_t k, int threads,
                      uint32_t *nearest, double *nearest2);
//<

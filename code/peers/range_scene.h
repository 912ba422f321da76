// What the structures and the libraries of chapter 12 are asked.
#pragma once
#include "ch12-range-queries/structures.h"
#include <stdint.h>

enum { K = 8, BOXES = 10000 };

// The same points in both layouts, the boxes, and the right answers.
struct range_scene {
    struct point_set points;
    double *row, *box;
    double distance;
    uint32_t *nearest, *found;
    double *nearest2, *right2, *distance2;
    uint64_t within, in_boxes; // right ones; 0: not known
};

// n points of a kind in d dimensions; how many are within the distance
// and in boxes is not known yet. The points are released by
// point_set_free, the rest belongs to the experiment.
struct range_scene range_scene_of(const char *kind, uint32_t n, int d);

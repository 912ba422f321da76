// What the structures and the libraries of chapter 12 are asked: the
// nearest of each point, all within a distance, and points in boxes.
#pragma once
#include "ch12-range-queries/structures.h"
#include <stdint.h>

enum { NEIGHBORS_WANTED = 8, BOX_COUNT = 10000 };

enum task { BUILD, NEAREST_ONES, ALL_WITHIN, IN_BOXES, TASKS };

// What a program has taken, and how many points it has found.
struct range_run {
    double ns[TASKS]; // each, but building is of all; 0: not asked
    uint64_t within, in_boxes;
};

// The same points in both layouts, the boxes, and the right answers.
struct range_scene {
    struct point_set points;
    double *row, *box;
    double distance;
    uint32_t *nearest, *found;
    double *nearest2, *right2, *distance2;
    struct found *neighbor;    // room for all points
    uint64_t within, in_boxes; // right ones; 0: not known
};

// n points of a kind in d dimensions; how many are within the distance
// and in boxes is not known yet. The points are released by
// point_set_free, the rest belongs to the experiment.
struct range_scene range_scene_of(const char *kind, uint32_t n, int d);

// Fails if the program's answers, the distances in nearest2 among them,
// are not the right ones; libraries may have rounded differently. What
// has not been asked is not compared.
void compare_answers(const char *program, const struct range_run *run,
                     const struct range_scene *scene);

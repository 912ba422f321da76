//> List the algorithms
// To add one, include its header and add its row. The fastest stands
// last: where none is asked for, the last row that fits is taken.
#include "algorithms.h"
#include "ch02-all-pairs/naive.h"
#include "ch02-all-pairs/tiles.h"
#include "ch03-half-pairs/guarded.h"
#include "ch03-half-pairs/private.h"
#include "ch03-half-pairs/triangle.h"
#include "ch03-half-pairs/triangle_tiles.h"
#include "ch04-cell-sort/batches.h"
#include "ch04-cell-sort/point_by_point.h"
#include "ch05-collisions/cells_threads.h"
#include "ch05-collisions/groups.h"
#include "ch07-spiral/spiral.h"
#include "ch08-vector-spiral/vector_spiral.h"
#include "ch09-row-spans/row_spans.h"
#include "ch10-furthest/furthest_cells.h"
#include "ch10-furthest/furthest_hull.h"
#include "ch10-furthest/near_and_far.h"
#include "ch11-crowds/adaptive.h"
#include "ch11-crowds/by_sample.h"
#include "common/fail.h"
#include <string.h>

//> Give every algorithm its row
const struct algorithm algorithms[] = {
    //> Give the plain search its row
    {"naive", 2, STANDARD | WRAPAROUND, NEAREST | FURTHEST, "n^2",
     "every pair, plainly", naive},
    //<
    {"triangle", 3, STANDARD | WRAPAROUND, NEAREST | FURTHEST, "n^2/2",
     "every pair once", triangle},
    {"triangle-critical", 3, STANDARD | WRAPAROUND, NEAREST | FURTHEST,
     "n^2/2", "one lock behind a look", triangle_critical},
    {"triangle-atomic", 3, STANDARD | WRAPAROUND, NEAREST | FURTHEST,
     "n^2/2", "a lock in each best", triangle_atomic},
    {"triangle-reduction", 3, STANDARD | WRAPAROUND, NEAREST | FURTHEST,
     "n^2/2", "private answers, merged", triangle_reduction},
    {"tiles", 2, STANDARD | WRAPAROUND, NEAREST | FURTHEST, "n^2",
     "eight points at a time", tiles},
    {"triangle-tiles", 3, STANDARD | WRAPAROUND, NEAREST | FURTHEST,
     "n^2/2", "half the pairs in tiles", triangle_tiles},
    {"cells-lists", 4, STANDARD | WRAPAROUND, NEAREST, "n",
     "a list for every cell", cells_lists},
    {"cells-indices", 4, STANDARD | WRAPAROUND, NEAREST, "n",
     "indices sorted by cell", cells_indices},
    {"cells-sorted", 4, STANDARD | WRAPAROUND, NEAREST, "n",
     "points sorted by cell", cells_sorted},
    {"spiral", 7, STANDARD | WRAPAROUND, NEAREST, "n",
     "out in layers of cells", spiral},
    {"vector-spiral", 8, STANDARD | WRAPAROUND, NEAREST, "n",
     "spiral searches in step", vector_spiral},
    {"cells-groups", 5, STANDARD | WRAPAROUND, NEAREST, "n",
     "sorted 64 at a time", cells_groups},
    {"cells", 4, STANDARD | WRAPAROUND, NEAREST, "n",
     "batches of four queries", cells_batched},
    {"cells-threads", 5, STANDARD | WRAPAROUND, NEAREST, "n",
     "sorted by all threads", cells_threads},
    {"row-spans", 9, STANDARD | WRAPAROUND, NEAREST, "n",
     "eight share three spans", row_spans},
    {"furthest-cells", 10, STANDARD | WRAPAROUND, FURTHEST, "n",
     "cells from outside in", furthest_cells},
    {"furthest-hull", 10, STANDARD, FURTHEST, "n log n",
     "corners of the hull", furthest_hull},
    {"near-and-far", 10, STANDARD | WRAPAROUND, NEAREST | FURTHEST, "n",
     "spans, and few corners", near_and_far},
    {"adaptive", 11, STANDARD | WRAPAROUND, NEAREST | FURTHEST,
     "n log n", "a grid in every piece", adaptive},
    {"by-sample", 11, STANDARD | WRAPAROUND, NEAREST | FURTHEST,
     "n log n", "one grid, or pieces", by_sample},
};
//<

const int algorithm_count = sizeof algorithms / sizeof *algorithms;

//> Look an algorithm up
const struct algorithm *find_algorithm(const char *name)
{
    for (int row = 0; row < algorithm_count; row++)
        if (strcmp(algorithms[row].name, name) == 0)
            return &algorithms[row];
    return NULL;
}

const struct algorithm *fastest_algorithm(enum geometry geometry,
                                          enum answer answer)
{
    for (int row = algorithm_count - 1; row >= 0; row--)
        if (algorithms[row].geometries & geometry &&
            algorithms[row].answers & answer)
            return &algorithms[row];
    return NULL;
}
//<

//> Count an algorithm's operations
struct counts count_operations(const struct algorithm *algorithm,
                               const struct question *question,
                               struct answers *answers)
{
    struct counts counts = {0};
    struct question counted = *question;
    counted.counts = &counts;
    algorithm->run(&counted, answers);
    return counts;
}
//<
//<

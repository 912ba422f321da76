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
#include <string.h>

#ifdef COUNTING
#define TABLE counting_algorithms
#else
#define TABLE algorithms
#endif

//> Give every algorithm its row
const struct algorithm TABLE[] = {
    {"naive", 2, STANDARD | WRAPAROUND, NEAREST | FURTHEST, "n^2",
     "every other point, as plainly as can be", naive},
    {"triangle", 3, STANDARD | WRAPAROUND, NEAREST | FURTHEST, "n^2/2",
     "every distance once, on one thread", triangle},
    {"triangle-critical", 3, STANDARD | WRAPAROUND, NEAREST | FURTHEST,
     "n^2/2", "threads queue to change a best", triangle_critical},
    {"triangle-atomic", 3, STANDARD | WRAPAROUND, NEAREST | FURTHEST,
     "n^2/2", "every best is its own lock", triangle_atomic},
    {"triangle-reduction", 3, STANDARD | WRAPAROUND, NEAREST | FURTHEST,
     "n^2/2", "answers of its own for every thread",
     triangle_reduction},
    {"tiles", 2, STANDARD | WRAPAROUND, NEAREST | FURTHEST, "n^2",
     "eight points at a time meet every other", tiles},
    {"triangle-tiles", 3, STANDARD | WRAPAROUND, NEAREST | FURTHEST,
     "n^2/2", "half the pairs in tiles, on vectors", triangle_tiles},
};
//<

#ifndef COUNTING
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
    counting_take();
    counting_algorithms[algorithm - algorithms].run(question, answers);
    return counting_take();
}
//<
#endif
//<

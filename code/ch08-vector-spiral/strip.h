//> Declare the strip of tasks
// The searches of many points as tasks that march in step (Su): arrays
// with an element for each task, and lists of those that take part. A
// task is not a process, only what a search has to remember. A strip
// has the tasks of so many points that follow each other in the order
// of the cells.
#pragma once
#include "ch06-pack-scan/primitives.h"
#include "ch07-spiral/seek.h"
#include <stddef.h>

enum side { WEST, EAST, SOUTH, NORTH, SIDES };

//> List tasks and where they may go
struct tasks {
    uint32_t n;
    uint32_t *task;        // its number in the strip
    int32_t *column, *row; // its home
    int32_t *reach[SIDES]; // steps from there that it may take
};
//<

//> List visits to a cell
// Each task at most once. Of its cell, it has yet to look at the points
// point[at] .. point[end - 1]; at < end.
struct visits {
    uint32_t n;
    uint32_t *task, *at, *end;
};
//<

//> Tally what passes through the loops
enum { LAYERS_TALLIED = 8, LANES_TALLIED = 8 };

struct tally {
    uint64_t tasks;
    uint64_t seeking[LAYERS_TALLIED]; // tasks at layer k in phase one
    uint64_t looking[LAYERS_TALLIED]; // and in phase two
    uint64_t shown[LAYERS_TALLIED];   // cells of it that they look at
    uint64_t listed;                  // tasks before a list is packed
    uint64_t steps;                   // tried by the curtains
    uint64_t tried, looked, entered;  // cells: by all tasks of a list,
                                      // in the window, with points
    uint64_t points;                  // looked at
    uint64_t enters, looks;           // times that these loops ran
    uint64_t lanes, unpacked;         // in it: with packing, without
};
//<

//> Remember what a task must remember
struct strip {
    uint32_t first;        // task t is that of point[first + t]
    double *x, *y, *best2; // as of one who seeks
    uint32_t *nearest;
    int32_t *ended;     // the layer in which phase one did
    struct tasks all;   // in order
    struct tasks some;  // those of a layer
    struct visits here; // those at a cell
    struct tally tally;
    //> Leave room between the loops
    const struct primitives *primitives;
    uint8_t *keep;
    uint32_t *cell, *point, *least;
    double *point_x, *point_y, *task_x, *task_y, *best;
    //<
};
//<

// The bytes that a task takes.
enum { TASK_BYTES = 8 * sizeof(double) + 22 * sizeof(uint32_t) + 1 };

// Room for so many tasks, to be released with strip_free.
struct strip strip_allocate(const struct primitives *primitives,
                            uint32_t length);
void strip_free(struct strip *strip);
//<

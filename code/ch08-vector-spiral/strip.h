//> Declare the strip of tasks
// The searches of many points as tasks that advance in step (Su, about
// 1990). A task is not a process, only what a search has to remember
// between two steps: an element in each of some arrays. A strip has
// the tasks of points that follow each other in the order of the cells.
// Lists of task numbers say which tasks take part in a loop.
#pragma once
#include "ch06-pack-scan/primitives.h"
#include "ch07-spiral/spiral_search.h"
#include <stddef.h>

//> List tasks and their search bounds
enum side { WEST, EAST, SOUTH, NORTH, SIDES };

struct tasks {
    uint32_t n;
    uint32_t *task;        // its number in the strip
    int32_t *column, *row; // the cell of its query
    int32_t *bound[SIDES]; // steps from there that it may take
};
//<

//> List visits to a cell
// No task twice. Of its cell, the points point[at] .. point[end - 1]
// are still to be compared, of the array of chapter 4; at < end.
struct visits {
    uint32_t n;
    uint32_t *task, *at, *end;
};
//<

//> Tally what passes through the loops
enum { LAYERS_TALLIED = 8, LANES_TALLIED = 8 };

struct tally {
    uint64_t tasks;
    uint64_t phase_one[LAYERS_TALLIED]; // tasks at layer k
    uint64_t phase_two[LAYERS_TALLIED];
    uint64_t of_layer[LAYERS_TALLIED]; // cells of it that are visited
    uint64_t listed;         // tasks, before their list is packed
    uint64_t bound_steps;    // tried to find the search bounds
    uint64_t tried;          // tasks of a list, at each step of it
    uint64_t visited;        // cells within the bounds
    uint64_t entered;        // of these, with points
    uint64_t compared;       // points
    uint64_t cell_steps;     // calls of enter_cells
    uint64_t point_rounds;   // calls of compare_points
    uint64_t lanes;          // taken by it, in vectors of eight
    uint64_t lanes_unpacked; // if nothing were ever packed
};
//<

//> Remember what a task must remember
struct strip {
    uint32_t first;    // task t is the search of point[first + t]
    double *x, *y;     // its query
    double *best2;     // squared distance to `nearest`
    uint32_t *nearest; // at first NO_INDEX
    int32_t *phase_one_layer; // in which phase one ended
    struct tasks all;         // in order
    struct tasks layer;       // those that take part in a layer
    struct visits here;       // those at a cell
    struct tally tally;
    //> Leave room between the loops
    const struct primitives *primitives;
    uint8_t *keep;
    uint32_t *cell, *point, *gathered_nearest;
    double *point_x, *point_y, *task_x, *task_y, *best;
    //<
};
//<

//> Count the bytes of a task
enum { TASK_BYTES = 8 * sizeof(double) + 22 * sizeof(uint32_t) + 1 };
//<

// Room for so many tasks, to be released with strip_free. Each array
// has SPILL more elements than that.
struct strip strip_allocate(const struct primitives *primitives,
                            uint32_t length);
void strip_free(struct strip *strip);

// Adds every count of the second to the first.
void tally_add(struct tally *sum, const struct tally *tally);
//<

//> Declare the march
// Spiral searches of many points in step: layer by layer, in each layer
// cell by cell, in each cell point by point; all tasks of a strip take
// the same steps, and those that have nothing to do in a loop are
// packed away before it (Su, figures 6 to 8).
#pragma once
#include "ch08-vector-spiral/loops.h"

//> Time the march by its loops
// For an experiment, on one thread: the time in each, and how often the
// march came to it.
enum phase { IN_LAYERS, IN_CELLS, IN_POINTS, PHASES };

struct watch {
    enum phase phase;
    int64_t since, ns[PHASES];
    uint64_t turns[PHASES];
};
//<

// Answers all points, nearest only, in strips of so many tasks, at
// least 1; threads share out the strips. Tally and watch may be NULL.
void march(const struct question *question, const struct grid *grid,
           const struct cells *cells, const struct loops *loops,
           uint32_t length, struct answers *answers,
           struct tally *tally, struct watch *watch);
//<

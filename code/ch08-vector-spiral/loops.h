//> Declare the two inner loops
// What all tasks of a strip do at a cell, and at a point of it (Su,
// figures 7 and 8). There are several versions, and all of them change
// a strip in the same way.
#pragma once
#include "ch08-vector-spiral/strip.h"

// Enter: of these tasks, list as visits of the strip those that may go
// dx steps on and dy steps up and find a point there. Look: every visit
// looks at its next point, and those for which it was the last of their
// cell are packed away.
struct loops {
    enum isa isa;
    void (*enter)(const struct map *map, struct strip *strip,
                  const struct tasks *tasks, int32_t dx, int32_t dy);
    void (*look)(const struct map *map, struct strip *strip);
};

// So many steps on along an axis; only wraparound goes beyond its ends.
INLINED int32_t go(const enum geometry geometry,
                   const struct axis *axis, int32_t cell, int32_t steps)
{
    int32_t m = axis->count, to = cell + steps;
    if (geometry == STANDARD)
        return to;
    return to < 0 ? to + m : to < m ? to : to - m;
}
//<

//> Declare who looks far
// One who looks for his furthest point, in cells that others choose
// for him.
#pragma once
#include "ch02-all-pairs/pair.h"
#include "ch04-cell-sort/block.h"
#include "ch04-cell-sort/sorted.h"
#include "common/count.h"

//> Hold one who looks far
struct viewer {
    double x, y, most2;
    uint32_t self, furthest; // indices
};

// As long as nobody is further than 0, the first of the others is.
static inline struct viewer viewer_of(const struct sorted *sorted,
                                      uint32_t s)
{
    uint32_t self = sorted->cells.point[s];
    return (struct viewer){sorted->points.x[s], sorted->points.y[s], 0,
                           self, self == 0};
}
//<

//> Look far in a cell
// Nobody in it is further than bound2. Once somebody is as far as that,
// the rest of the cell need not be asked: their indices are higher.
INLINED void look_at(const enum geometry geometry, struct space space,
                     const struct sorted *sorted, uint32_t cell,
                     double bound2, struct viewer *viewer)
{
    const uint32_t *point = sorted->cells.point;
    const uint32_t end = sorted->cells.start[cell + 1];
    uint32_t s = sorted->cells.start[cell];
    for (; s < end &&
           (viewer->most2 < bound2 ||
            (viewer->most2 == bound2 && point[s] < viewer->furthest));
         s++) {
        double far2 =
            pair2(geometry, space, sorted->points.x[s] - viewer->x,
                  sorted->points.y[s] - viewer->y)
                .far2;
        if (point[s] != viewer->self &&
            (far2 > viewer->most2 ||
             (far2 == viewer->most2 && point[s] < viewer->furthest))) {
            viewer->most2 = far2;
            viewer->furthest = point[s];
        }
    }
    COUNT(cells, 1);
    COUNT(distances, s - sorted->cells.start[cell]);
}
//<
//<

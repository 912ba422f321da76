//> Measure a pair, near and far
// The distance of a pair in both of its meanings at once, for loops
// that are compiled once per geometry. Bitwise the distances of
// geometry.h: rounding keeps order, so that the smaller of two squares
// is the square of the smaller.
#pragma once
#include "common/inlined.h"
#include "common/question.h"

//> Hold both distances of a pair
struct pair_distances {
    double near2, far2; // squared, to the closest, furthest image
};
//<

//> Measure both images at once
INLINED struct pair_distances pair2(const enum geometry geometry,
                                    struct space space, double dx,
                                    double dy)
{
    double ax2 = dx * dx, ay2 = dy * dy;
    if (geometry == STANDARD)
        return (struct pair_distances){ax2 + ay2, ax2 + ay2};
    double bx = space.width - fabs(dx), by = space.height - fabs(dy);
    double bx2 = bx * bx, by2 = by * by;
    return (struct pair_distances){
        (ax2 < bx2 ? ax2 : bx2) + (ay2 < by2 ? ay2 : by2),
        (ax2 > bx2 ? ax2 : bx2) + (ay2 > by2 ? ay2 : by2)};
}
//<

//> Answer for some of the rows
// Answers for points begin .. end-1, on one thread.
typedef void rows_function(const struct question *question,
                           struct answers *answers, uint32_t begin,
                           uint32_t end);

// Defines the rows_function NAME_rows, which calls a copy of the
// INLINED function NAME(geometry, question, answers, begin, end).
#define SPECIALIZE(name)                                      \
    void name##_rows(const struct question *question,         \
                     struct answers *answers, uint32_t begin, \
                     uint32_t end)                            \
    {                                                         \
        if (question->space.geometry == STANDARD)             \
            name(STANDARD, question, answers, begin, end);    \
        else                                                  \
            name(WRAPAROUND, question, answers, begin, end);  \
    }

// Calls one of two copies of an INLINED function, that for the geometry
// of the space.
#define IN_GEOMETRY(space, function, ...)                           \
    ((space).geometry == STANDARD ? function(STANDARD, __VA_ARGS__) \
                                  : function(WRAPAROUND, __VA_ARGS__))
//<
//<

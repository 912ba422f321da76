//> Declare the coursework's program
// The nearest and furthest neighbors as the coursework has them: the
// distance is a function that the caller passes, and the function
// leaves {closest, furthest} in an array. n (n-1) calls.
#pragma once
#include "ch02-all-pairs/pair.h"

//> Declare a distance that is passed
// Squared distances of a pair whose coordinates differ by dx, dy.
typedef void measure_function(const struct space *space, double dx,
                              double dy, double result[2]);
//<

measure_function measure_standard, measure_wraparound;
measure_function measure_pow;          // standard, with pow(dx, 2.0)
measure_function measure_pow_variable; // the same, the 2.0 out of sight

// Searches with any of them; rows begin .. end-1, on one thread.
void first_search(const struct question *question,
                  struct answers *answers, measure_function *measure,
                  uint32_t begin, uint32_t end);

rows_function first_rows; // with the one of the question's geometry

//> Measure into an array
static inline void in_standard(const struct space *space, double dx,
                               double dy, double result[2])
{
    (void)space;
    result[0] = result[1] = dx * dx + dy * dy;
}

static inline void in_wraparound(const struct space *space, double dx,
                                 double dy, double result[2])
{
    double ax = fabs(dx), bx = space->width - ax;
    double ay = fabs(dy), by = space->height - ay;
    double near_x = ax < bx ? ax : bx, near_y = ay < by ? ay : by;
    double far_x = ax < bx ? bx : ax, far_y = ay < by ? by : ay;
    result[0] = near_x * near_x + near_y * near_y;
    result[1] = far_x * far_x + far_y * far_y;
}
//<
//<

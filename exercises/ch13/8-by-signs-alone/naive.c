// Takes every 0 for a miss: general position only.
// expect: 3 of 10
#include "exercise.h"

bool segment_meets_triangle(void)
{
    if (side_of(0, 1, 2, 3) * side_of(0, 1, 2, 4) >= 0)
        return false;
    const int way = side_of(3, 4, 0, 1);
    return way != 0 && side_of(3, 4, 1, 2) == way &&
           side_of(3, 4, 2, 0) == way;
}

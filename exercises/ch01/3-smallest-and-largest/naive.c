// Two searches, one for each extreme.
// expect: 4 of 10
#include "exercise.h"

struct extremes find_extremes(uint32_t n)
{
    struct extremes best = {0, 0};
    for (uint32_t i = 1; i < n; i++) {
        if (less(i, best.smallest))
            best.smallest = i;
        if (less(best.largest, i))
            best.largest = i;
    }
    return best;
}

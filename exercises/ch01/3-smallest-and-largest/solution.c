// The smallest and the largest of n values with three comparisons for
// two values: compare them with each other first, then the smaller one
// with the smallest and the larger one with the largest so far.
#include "exercise.h"

struct extremes find_extremes(uint32_t n)
{
    //- solution
    struct extremes best = {0, 0};
    for (uint32_t i = n % 2; i < n; i += 2) {
        bool rising = less(i, i + 1);
        uint32_t small = rising ? i : i + 1;
        uint32_t large = rising ? i + 1 : i;
        if (i == 0) {
            best = (struct extremes){small, large};
            continue;
        }
        if (less(small, best.smallest))
            best.smallest = small;
        if (less(best.largest, large))
            best.largest = large;
    }
    return best;
    //- starter
    // // Your turn. So far: the smallest, and it only.
    // struct extremes best = {0, 0};
    // for (uint32_t i = 1; i < n; i++)
    //     if (less(i, best.smallest))
    //         best.smallest = i;
    // return best;
    //- end
}

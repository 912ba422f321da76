// Measures all leaves.
// expect: 4 of 10
#include "exercise.h"
#include <math.h>

double nearest2(const struct tree *tree, const double place[2])
{
    double best2 = INFINITY;
    (void)place;
    for (uint32_t leaf = 0; leaf < tree->leaves; leaf++)
        best2 = fmin(best2, measure_leaf(leaf));
    return best2;
}

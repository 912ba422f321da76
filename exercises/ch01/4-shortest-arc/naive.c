// Tries an arc from every point, with every point: n times n steps.
// expect: 4 of 10
#include "exercise.h"

struct arc shortest_arc(const double *x, uint32_t n)
{
    struct arc best = {x[0], 2};
    for (uint32_t i = 0; i < n; i++) {
        struct arc arc = {x[i], 0};
        for (uint32_t j = 0; j < n; j++) {
            double length = x[j] - x[i];
            if (length < 0)
                length += 1;
            if (length > arc.length)
                arc.length = length;
        }
        if (arc.length < best.length)
            best = arc;
    }
    return best;
}

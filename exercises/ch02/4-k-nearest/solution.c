// The k nearest neighbors of a point: the best so far are kept sorted,
// and every better point is inserted where it belongs.
#include "common/geometry.h"
#include "exercise.h"

void k_nearest(struct points points, uint32_t i, uint32_t k,
               uint32_t *neighbors, double *distances2)
{
    //- solution
    uint32_t found = 0;
    for (uint32_t j = 0; j < points.n; j++) {
        if (j == i)
            continue;
        double d2 = distance2(points.x[j] - points.x[i],
                              points.y[j] - points.y[i]);
        if (found == k && d2 >= distances2[k - 1])
            continue;
        uint32_t place = found < k ? found++ : k - 1;
        while (place > 0 && distances2[place - 1] > d2) {
            neighbors[place] = neighbors[place - 1];
            distances2[place] = distances2[place - 1];
            place--;
        }
        neighbors[place] = j;
        distances2[place] = d2;
    }
    //- starter
    // // Your turn. So far: the first k points, near or far.
    // for (uint32_t place = 0; place < k; place++) {
    //     double d2 = distance2(points.x[place] - points.x[i],
    //                           points.y[place] - points.y[i]);
    //     neighbors[place] = place;
    //     distances2[place] = d2;
    // }
    //- end
}

// The nearest pair in parallel: every thread finds its own best, and
// one at a time they hand it in.
#include "exercise.h"
#include <math.h>
#include <stdbool.h>

//- solution
// The order of pairs: by distance, and where they tie, by index. It
// makes the answer independent of which thread comes first.
static bool better(struct pair a, struct pair b)
{
    if (a.distance2 != b.distance2)
        return a.distance2 < b.distance2;
    return a.i < b.i || (a.i == b.i && a.j < b.j);
}

//- starter
//- end
struct pair nearest_pair(uint32_t n, int threads)
{
    struct pair best = {.distance2 = INFINITY};
//- solution
#pragma omp parallel num_threads(threads)
    {
        struct pair mine = {.distance2 = INFINITY};
#pragma omp for schedule(dynamic) nowait
        for (uint32_t i = 0; i < n; i++)
            for (uint32_t j = i + 1; j < n; j++) {
                struct pair pair = {i, j, measure(i, j)};
                if (better(pair, mine))
                    mine = pair;
            }
#pragma omp critical
        if (better(mine, best))
            best = mine;
    }
    //- starter
    // // Your turn. So far: one thread, and not all the pairs.
    // for (uint32_t i = 0; i + 1 < n; i++) {
    //     struct pair pair = {i, i + 1, measure(i, i + 1)};
    //     if (pair.distance2 < best.distance2)
    //         best = pair;
    // }
    //- end
    return best;
}

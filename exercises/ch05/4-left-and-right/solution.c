// The stable parallel partition: every thread counts its own points,
// one sums the counts, every thread places its own points.
#include "common/fail.h"
#include "exercise.h"
#include <omp.h>
#include <stdlib.h>

uint32_t divide(uint32_t n, uint32_t *point, int threads)
{
    //- solution
    // left[t]: how many are on the left of the points before thread t's
    uint32_t *left = allocate(threads + 1, sizeof *left);
    uint32_t lefts = 0;
#pragma omp parallel num_threads(threads)
    {
        int t = omp_get_thread_num(), all = omp_get_num_threads();
        uint32_t from = (uint64_t)n * t / all;
        uint32_t to = (uint64_t)n * (t + 1) / all;
        uint32_t mine = 0;
        for (uint32_t i = from; i < to; i++)
            mine += is_left(i);
        left[t + 1] = mine;
#pragma omp barrier
#pragma omp single
        {
            left[0] = 0;
            for (int s = 0; s < all; s++)
                left[s + 1] += left[s];
            lefts = left[all];
        }
        uint32_t l = left[t], r = lefts + (from - left[t]);
        for (uint32_t i = from; i < to; i++)
            if (is_left(i))
                point[l++] = i;
            else
                point[r++] = i;
    }
    free(left);
    //- starter
    // // Your turn. So far: one thread, and only one half.
    // uint32_t lefts = 0;
    // for (uint32_t i = 0; i < n; i++)
    //     if (is_left(i))
    //         point[lefts++] = i;
    //- end
    return lefts;
}

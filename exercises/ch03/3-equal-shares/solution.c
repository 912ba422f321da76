// Shares of the triangle: thread t stops at the first row at which
// t + 1 shares of all pairs are done.
#include "exercise.h"

void share_rows(uint32_t n, int threads, uint32_t *first)
{
    //- solution
    uint64_t all = (uint64_t)n * (n - 1) / 2, done = 0;
    uint32_t i = 0;
    for (int t = 0; t < threads; t++) {
        first[t] = i;
        while (done * threads < all * (t + 1))
            done += n - 1 - i++;
    }
    first[threads] = n;
    //- starter
    // // Your turn. So far: the first thread does everything.
    // first[0] = 0;
    // for (int t = 1; t <= threads; t++)
    //     first[t] = n;
    //- end
}

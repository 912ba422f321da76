// A side and the corner that is highest above it hold the hull between
// two parallel jaws. From side to side that corner moves on, never
// back.
#include "exercise.h"

//- solution
static void keep(struct pair *best, uint32_t i, uint32_t j)
{
    struct pair pair = {i < j ? i : j, i < j ? j : i, measure(i, j)};
    if (pair.d2 > best->d2 ||
        (pair.d2 == best->d2 &&
         (pair.i < best->i || (pair.i == best->i && pair.j < best->j))))
        *best = pair;
}

//- starter
//- end
struct pair diameter(uint32_t n)
{
    //- solution
    struct pair best = {.d2 = -1};
    uint32_t k = 1 % n;
    for (uint32_t i = 0; i < n; i++) {
        while (height(i, (k + 1) % n) > height(i, k))
            k = (k + 1) % n;
        keep(&best, i, k);
    }
    return best;
    //- starter
    // // Your turn: this takes the corner half-way around.
    // return (struct pair){0, n / 2, measure(0, n / 2)};
    //- end
}

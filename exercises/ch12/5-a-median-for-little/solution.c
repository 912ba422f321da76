// Two bounds from a sample; Hoare's method for what is left.
#include "exercise.h"
//- solution
#include <math.h>

// Hoare's method, on a list that it reorders.
static uint32_t find(uint32_t *list, uint32_t n, uint32_t rank)
{
    while (n > 1) {
        const uint32_t pivot = list[n / 2];
        uint32_t below = 0, last = n - 1;
        list[n / 2] = list[last];
        for (uint32_t k = 0; k < last; k++)
            if (is_less(list[k], pivot)) {
                const uint32_t swap = list[k];
                list[k] = list[below];
                list[below++] = swap;
            }
        if (rank == below)
            return pivot;
        if (rank < below) {
            n = below;
        } else {
            list += below;
            n = last - below;
            rank -= below + 1;
        }
    }
    return list[0];
}

// The number of this place in a sample of m.
static uint32_t bound(uint32_t n, uint32_t m, double place,
                      uint32_t *room)
{
    for (uint32_t k = 0; k < m; k++)
        room[k] = (uint64_t)k * n / m;
    return find(room, m, (uint32_t)fmin(fmax(place, 0), m - 1));
}
//- starter
//- end

uint32_t number_of_rank(uint32_t n, uint32_t rank, uint32_t *room)
{
    //- solution
    const uint32_t m = (uint32_t)pow(n, 2.0 / 3);
    const double place = (double)rank * m / n, gap = 1.5 * sqrt(m);
    uint32_t below = 0, kept = 0;
    if (n > 600 && place - gap >= 0 && place + gap < m) {
        const uint32_t low = bound(n, m, place - gap, room);
        const uint32_t high = bound(n, m, place + gap, room);
        for (uint32_t k = 0; k < n; k++) {
            if (is_less(k, low))
                below++;
            else if (!is_less(high, k))
                room[kept++] = k;
        }
    }
    if (rank >= below && rank - below < kept)
        return find(room, kept, rank - below);
    for (uint32_t k = 0; k < n; k++)
        room[k] = k;
    return find(room, n, rank);
    //- starter
    // // Your turn: so far it answers with the rank itself.
    // (void)n, (void)room;
    // return rank;
    //- end
}

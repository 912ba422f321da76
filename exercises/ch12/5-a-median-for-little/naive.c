// Sorts them all, by merging.
// expect: 4 of 10
#include "exercise.h"

static void sort(uint32_t *list, uint32_t n, uint32_t *room)
{
    if (n < 2)
        return;
    const uint32_t half = n / 2;
    sort(list, half, room);
    sort(list + half, n - half, room);
    uint32_t i = 0, j = half, k = 0;
    while (i < half && j < n)
        room[k++] = is_less(list[j], list[i]) ? list[j++] : list[i++];
    while (i < half)
        room[k++] = list[i++];
    while (k > 0) {
        k--;
        list[k] = room[k];
    }
}

uint32_t number_of_rank(uint32_t n, uint32_t rank, uint32_t *room)
{
    for (uint32_t k = 0; k < n; k++)
        room[k] = k;
    sort(room, n, room + n);
    return room[rank];
}

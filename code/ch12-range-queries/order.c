//> Sort and repair orders
// A sort by digits takes the same time for any numbers; an insertion,
// one step for each reference and one for each shift.
#include "ch12-range-queries/order.h"

//> Sort the references
void sort_order(const double *x, uint32_t *order, uint32_t n,
                struct radix_record *room)
{
    for (uint32_t i = 0; i < n; i++)
        room[i] = (struct radix_record){radix_key(x[i]), i};
    radix_sort(room, n, 64, room + n);
    for (uint32_t r = 0; r < n; r++)
        order[r] = room[r].point;
}
//<

//> Repair the order
// By insertion: a reference goes past those with a greater number,
// which are shifted by a place. Gives up after so many shifts.
uint64_t repair_order(const double *x, uint32_t *order, uint32_t n,
                      struct radix_record *room)
{
    const uint64_t max_shifts = (uint64_t)MAX_SHIFTS * n;
    uint64_t shifts = 0;
    for (uint32_t r = 1; r < n && shifts <= max_shifts; r++) {
        const uint32_t moved = order[r];
        uint32_t place = r;
        for (; place > 0 && x[order[place - 1]] > x[moved]; place--)
            order[place] = order[place - 1];
        order[place] = moved;
        shifts += r - place;
    }
    if (shifts > max_shifts)
        sort_order(x, order, n, room);
    return shifts;
}
//<
//<

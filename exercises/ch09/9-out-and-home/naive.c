// A count and a scan, and each record straight to its place.
// expect: 4 of 10
#include "exercise.h"

void go_out(uint32_t n)
{
    static uint32_t next[RECORDS_MOST + 1];
    for (uint32_t k = 0; k <= n; k++)
        next[k] = 0;
    for (uint32_t i = 0; i < n; i++)
        next[get(INPUT, i).cell + 1]++;
    for (uint32_t k = 0; k < n; k++)
        next[k + 1] += next[k];
    for (uint32_t i = 0; i < n; i++) {
        struct record record = get(INPUT, i);
        set(SORTED, next[record.cell]++, record);
    }
}

void go_home(uint32_t n)
{
    for (uint32_t s = 0; s < n; s++) {
        struct record record = get(SORTED, s);
        set(OUTPUT, record.index, record);
    }
}

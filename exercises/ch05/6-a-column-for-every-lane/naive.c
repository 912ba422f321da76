// One lane works, the others watch.
// expect: 4 of 10
#include "exercise.h"

void sort_by_cell(uint32_t n, const uint32_t *cell)
{
    uint32_t at, count;
    for (uint32_t i = 0; i < n; i++) {
        at = cell[i] * LANES;
        gather(COUNTS, 1, &at, &count);
        count++;
        scatter(COUNTS, 1, &at, &count);
    }
    scan_counts();
    for (uint32_t i = 0; i < n; i++) {
        at = cell[i] * LANES;
        gather(COUNTS, 1, &at, &count);
        scatter(PLACES, 1, &count, &i);
        count++;
        scatter(COUNTS, 1, &at, &count);
    }
}

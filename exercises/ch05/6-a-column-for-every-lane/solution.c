// The sort without collisions (Zagha and Blelloch, 1991): every lane
// has consecutive points and counts of its own, those of a cell side by
// side, so that the scan goes over cells first and lanes second.
#include "exercise.h"

//- solution
// The points of the lanes in step k, and where their counts are.
// Returns how many lanes have a point.
static uint32_t step(uint32_t n, const uint32_t *cell, uint32_t k,
                     uint32_t *point, uint32_t *column)
{
    uint32_t block = (n + LANES - 1) / LANES, lanes = 0;
    for (uint32_t i = k; i < n && lanes < LANES; i += block) {
        point[lanes] = i;
        column[lanes] = cell[i] * LANES + lanes;
        lanes++;
    }
    return lanes;
}

//- starter
//- end
void sort_by_cell(uint32_t n, const uint32_t *cell)
{
    //- solution
    uint32_t point[LANES], column[LANES], count[LANES], place[LANES];
    uint32_t block = (n + LANES - 1) / LANES;
    for (uint32_t k = 0; k < block; k++) {
        uint32_t lanes = step(n, cell, k, point, column);
        gather(COUNTS, lanes, column, count);
        for (uint32_t l = 0; l < lanes; l++)
            count[l]++;
        scatter(COUNTS, lanes, column, count);
    }
    scan_counts();
    for (uint32_t k = 0; k < block; k++) {
        uint32_t lanes = step(n, cell, k, point, column);
        gather(COUNTS, lanes, column, place);
        scatter(PLACES, lanes, place, point);
        for (uint32_t l = 0; l < lanes; l++)
            place[l]++;
        scatter(COUNTS, lanes, column, place);
    }
    //- starter
    // // Your turn. So far lanes share counts, and no point is placed.
    // uint32_t at[LANES], count[LANES], lanes;
    // for (uint32_t i = 0; i < n; i += lanes) {
    //     lanes = n - i < LANES ? n - i : LANES;
    //     for (uint32_t l = 0; l < lanes; l++)
    //         at[l] = cell[i + l] * LANES;
    //     gather(COUNTS, lanes, at, count);
    //     for (uint32_t l = 0; l < lanes; l++)
    //         count[l]++;
    //     scatter(COUNTS, lanes, at, count);
    // }
    // scan_counts();
    //- end
}

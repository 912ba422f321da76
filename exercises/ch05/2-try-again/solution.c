// The histogram by groups: in every round the winners are counted, and
// the losers move up and form the group of the next round.
#include "exercise.h"
#include <string.h>

//- solution
// One round: counts one point of every cell and moves the cells of the
// others to the front. Returns how many they are.
static uint32_t play(uint32_t lanes, uint32_t *cell)
{
    uint32_t number[LANES], read[LANES], count[LANES];
    for (uint32_t l = 0; l < lanes; l++)
        number[l] = l;
    scatter(SCRATCH, lanes, cell, number);
    gather(SCRATCH, lanes, cell, read);
    gather(COUNTS, lanes, cell, count);
    for (uint32_t l = 0; l < lanes; l++)
        count[l]++;
    scatter(COUNTS, lanes, cell, count);
    uint32_t losers = 0;
    for (uint32_t l = 0; l < lanes; l++)
        if (read[l] != l)
            cell[losers++] = cell[l];
    return losers;
}

//- starter
// // Your turn: this counts every cell of a group once, and no more.
// static uint32_t play(uint32_t lanes, uint32_t *cell)
// {
//     uint32_t count[LANES];
//     gather(COUNTS, lanes, cell, count);
//     for (uint32_t l = 0; l < lanes; l++)
//         count[l]++;
//     scatter(COUNTS, lanes, cell, count);
//     return 0;
// }
//
//- end
void histogram(uint32_t n, const uint32_t *cell)
{
    uint32_t group[LANES];
    for (uint32_t i = 0; i < n; i += LANES) {
        uint32_t lanes = n - i < LANES ? n - i : LANES;
        memcpy(group, cell + i, lanes * sizeof *group);
        //- solution
        for (uint32_t left = lanes; left > 0;)
            left = play(left, group);
        //- starter
        // play(lanes, group);
        //- end
    }
}

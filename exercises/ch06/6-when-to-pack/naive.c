// Packs when less than half of the lanes are alive.
// expect: 4 of 10
#include "exercise.h"

void work_off(uint32_t lanes, uint32_t price)
{
    uint32_t alive = lanes;
    (void)price;
    while (alive > 0) {
        alive = step();
        if (alive > 0 && alive < lanes / 2) {
            pack();
            lanes = alive;
        }
    }
}

// Pack when idle lanes have cost as much as the pack will. Whatever the
// lifetimes are, that is never more than twice the least possible.
#include "exercise.h"

void work_off(uint32_t lanes, uint32_t price)
{
    //- solution
    uint32_t alive = lanes;
    uint64_t idle = 0; // since the last pack
    while (alive > 0) {
        alive = step();
        idle += lanes - alive;
        if (alive > 0 && idle >= (uint64_t)price * lanes) {
            pack();
            lanes = alive;
            idle = 0;
        }
    }
    //- starter
    // // Your turn. So far no lane is ever packed away.
    // uint32_t alive = lanes;
    // while (alive > 0)
    //     alive = step();
    //- end
}
